// Law of damaged codes of any form: cut, longer, or with flipped bits.  Only the encoder can tell which of them are
// codes; the law judges that the decoder returns and gives a refusal or a scene.
#include "proofs/dag/law_parts.hpp"
#include "proofs/engine/random.hpp"

namespace mmverify::proofs::dag {
namespace {

constexpr std::uint64_t most_cuts = 40, most_flips = 60;
constexpr Level highest = 12;

/// The scene that a decoder makes of bytes; nothing if it refuses them.
std::optional<Scene> opened(const DagSubject& s, Format f, const Bytes& bytes) {
  const std::optional<Code> code = s.functions.open(f, bytes);
  return code ? std::optional(s.functions.decode(*code)) : std::nullopt;
}

bool is_scene(const Scene& scene) {
  return !scene.maps.empty() && std::all_of(scene.maps.begin(), scene.maps.end(), [&](const Map& map) {
    return map.level <= highest &&
           map.packed.size() ==
               spec::micromap::packed_bytes(spec::micromap::micro_triangles(map.level), scene.format);
  });
}

/// All numbers below `all`, or `most` of them at random.
std::vector<std::uint64_t> some_of(std::uint64_t all, std::uint64_t most, Random& random) {
  std::vector<std::uint64_t> some;
  for (std::uint64_t k = 0; k < std::min(all, most); ++k) some.push_back(all <= most ? k : random.below(all));
  return some;
}

Finding survives(const DagSubject& s, const Scene& scene) {
  const Bytes code = s.functions.bytes(s.functions.encode(scene));
  Random random(code.size(), scene.maps.size(), 5);
  std::vector<std::pair<std::string, Bytes>> damaged{{"a byte more", code}};
  damaged.back().second.push_back(0);
  for (const std::uint64_t size : some_of(code.size(), most_cuts, random))
    damaged.emplace_back(fmt::format("cut to {} bytes", size),
                         Bytes(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(size)));
  for (const std::uint64_t bit : some_of(8 * code.size(), most_flips, random)) {
    damaged.emplace_back(fmt::format("bit {} flipped", bit), code);
    std::uint8_t& byte = damaged.back().second[bit / 8];
    byte = static_cast<std::uint8_t>(byte ^ 1u << bit % 8);
  }
  damaged.emplace_back("no bytes", Bytes());
  std::uint64_t digest = 0;
  std::vector<std::optional<Scene>> answers;
  for (const auto& [what, bytes] : damaged) {
    answers.push_back(opened(s, scene.format, bytes));
    if (answers.back() && !is_scene(*answers.back()))
      return wrong(what + ": refused, or a scene", "no scene");
    digest = digest * 31 + (answers.back() ? answers.back()->maps.size() : 0);
  }
  // Repeats the questions backwards: earlier questions must not matter.
  for (std::size_t k = damaged.size(); k-- > 0;)
    if (opened(s, scene.format, damaged[k].second) != answers[k])
      return wrong(damaged[k].first + ": what it was before", "another answer");
  return {digest};
}

Change opens(
    std::function<void(std::span<const std::uint8_t>, std::optional<Code>&, const Functions& real)> change) {
  return [change](Functions& f) {
    f.open = [change, real = f](Format format, std::span<const std::uint8_t> bytes) {
      std::optional<Code> code = real.open(format, bytes);
      change(bytes, code, real);
      return code;
    };
  };
}

}  // namespace

Law damaged_codes_law() {
  return on_samples(
      {.id = "dag.damaged_codes",
       .says = "a code of any form that is cut, longer or changed in a bit is refused or decoded to a scene, "
               "the same one whenever it is asked; which of the two is right only the form's maker can say",
       .source = "the header's dag_decode; docs/DAG.md",
       .subjects = {"dag"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 6}, .seconds = 0.4},
       .how = "sample, by what comes back",
       .mutants = {mutant("the empty code is a scene without maps", "dag", {0, 0},
                          opens([](std::span<const std::uint8_t> bytes, std::optional<Code>& code,
                                   const Functions& real) {
                            if (bytes.empty()) code = real.encode({Format::two_state, {}});
                          })),
                   mutant("what was opened before shows", "dag", {4, 5},
                          [](Functions& f) {
                            f.open = [real = f, last = std::make_shared<std::size_t>(0)](
                                         Format format, std::span<const std::uint8_t> bytes) {
                              std::optional<Code> code = real.open(format, bytes);
                              if (!code && bytes.size() < *last) code = real.encode({format, {{0, {0}}}});
                              *last = bytes.size();
                              return code;
                            };
                          }),
                   mutant("a code cut by a byte has a map of level 13", "dag", {0, 2},
                          [](Functions& f) {
                            f.open = [real = f.open](Format format, std::span<const std::uint8_t> bytes) {
                              std::optional<Code> code = real(format, bytes);
                              if (!code && !bytes.empty() && bytes.size() % 8 == 7)
                                code = Code{format, nullptr};
                              return code;
                            };
                            f.decode = [real = f.decode](const Code& code) {
                              return code.form ? real(code) : Scene{code.format, {{13, {0}}}};
                            };
                          })}},
      {entry::decode}, [](Level) -> std::uint64_t { return 10; }, survives);
}

}  // namespace mmverify::proofs::dag
