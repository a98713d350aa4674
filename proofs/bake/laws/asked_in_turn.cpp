// bake.asked_in_turn: whether a baker takes a question for the one before, which differs from it in one thing alone.
#include "proofs/bake/domains/threshold.hpp"
#include "proofs/bake/laws/relation_judges.hpp"

namespace mmverify::proofs::bake {
namespace {

/// Changes a case in one thing, or leaves it as it is where it cannot.
struct Change {
  const char* what;
  void (*make)(Case& one);
};

void turn_round(Case& one, std::size_t from) {
  std::reverse(one.alpha.begin() + static_cast<std::ptrdiff_t>(std::min(from, one.alpha.size())),
               one.alpha.end());
  one.drawn.clear();
}

Wrap next_of(Wrap wrap) { return static_cast<Wrap>((static_cast<unsigned>(wrap) + 1) % 5); }

float other_factor(float factor) { return factor == 1 ? 0.5f : 1.0f; }

/// Each case is asked with these.
constexpr std::array always{
    Change{"its texels below the first row in the opposite order",
           [](Case& one) { turn_round(one, one.width); }},
    Change{"all its texels in the opposite order", [](Case& one) { turn_round(one, 0); }},
    Change{"the texels of its smaller mips in the opposite order",
           [](Case& one) { turn_round(one, texels_of(one.width, one.height, 1)); }},
};

/// And with some of these in turn.
constexpr std::array rotating{
    Change{"another border",
           [](Case& one) {
             one.border = one.border == highest(one.texel) ? lowest(one.texel) : highest(one.texel);
           }},
    Change{"other addressing of u", [](Case& one) { one.wrap_u = next_of(one.wrap_u); }},
    Change{"other addressing of v", [](Case& one) { one.wrap_v = next_of(one.wrap_v); }},
    Change{
        "the other filter",
        [](Case& one) { one.filter = one.filter == Filter::nearest ? Filter::bilinear : Filter::nearest; }},
    Change{"another factor", [](Case& one) { one.factor = other_factor(one.factor); }},
    Change{"another factor of the vertices",
           [](Case& one) { one.vertex_factor = other_factor(one.vertex_factor); }},
    Change{"the other alpha mode", [](Case& one) { one.blend = !one.blend; }},
    Change{"another cutoff",
           [](Case& one) {
             one.cutoff = 2 * std::uint64_t{one.cutoff.numerator} > one.cutoff.denominator ? Cutoff{1, 4}
                                                                                           : Cutoff{3, 4};
           }},
    Change{"another margin", [](Case& one) { one.margin = one.margin == 0 ? 1.0f : 0.0f; }},
    Change{"another first vertex", [](Case& one) { one.uv[0] += 0.5f / static_cast<float>(one.width); }},
    Change{"another last vertex", [](Case& one) { one.uv[5] -= 0.5f / static_cast<float>(one.height); }},
    Change{"its width for its height",
           [](Case& one) {
             if (one.mips == 1) std::swap(one.width, one.height), one.drawn.clear();
           }},
};
constexpr std::size_t turns = 3;  ///< of `rotating`, for each case

/// A question that shares its one texel with no other: nobody takes the case, or a changed one, for it.
Case of_another_texel(Case one) {
  one.width = one.height = one.mips = 1;
  one.alpha = {one.alpha.front() == highest(one.texel) ? lowest(one.texel) : highest(one.texel)};
  one.drawn.clear();
  return one;
}

Finding differ(const char* what, const char* after, const std::vector<State>& first,
               const std::vector<State>& again) {
  for (std::size_t at = 0; at < first.size(); ++at)
    if (first[at] != again[at])
      return wrong(
          fmt::format("{}, asked again after {}: micro-triangle {} {}", what, after, at, name_of(first[at])),
          name_of(again[at]));
  return {};
}

}  // namespace

Finding keeps_no_other(const BakeSubject& s, const Case& one, Level n) {
  const Case apart = of_another_texel(one);
  std::vector<Change> changes(always.begin(), always.end());
  map_of(s, apart, n);  // what was asked before this law's case is out of mind
  const std::vector<State> map = map_of(s, one, n);
  const std::uint64_t first_turn = hash_of(map) + one.alpha.size() + one.width;
  for (std::size_t k = 0; k < turns; ++k) changes.push_back(rotating[(first_turn + 5 * k) % rotating.size()]);
  for (const Change& change : changes) {
    Case other = one;
    change.make(other);
    if (!covers(s.functions.support, other)) continue;
    // The changed case is asked after the one that it was made from, then with another in between; so is the first one.
    const std::vector<State> warm = map_of(s, other, n);
    if (const Finding found = differ("the case", change.what, map, map_of(s, one, n)); !found.holds)
      return found;
    map_of(s, apart, n);
    if (const Finding found = differ(change.what, "the case itself", map_of(s, other, n), warm); !found.holds)
      return found;
    map_of(s, apart, n);
    if (const Finding found = differ("the case", "one of one other texel", map, map_of(s, one, n));
        !found.holds)
      return found;
  }
  return {hash_of(map)};
}

namespace {

/// Takes one thing of a case from another case.
using Take = void (*)(Case& one, const Case& from);

/// A thread's last question, asked again where one differs from it in that thing alone.
std::function<void(Functions&)> forgetting(Take take) {
  return [take](Functions& functions) {
    struct Memory {
      std::mutex lock;
      std::map<std::thread::id, Case> last;
    };
    functions.bake = [take, memory = std::make_shared<Memory>(), real = functions.bake](
                         const Case& one, Level n, Format format) {
      Case asked = one;
      {
        const std::lock_guard hold(memory->lock);
        Case& last = memory->last[std::this_thread::get_id()];
        take(asked, last);
        if (asked != last) asked = one;
        last = asked;
      }
      return real(asked, n, format);
    };
  };
}

}  // namespace

std::vector<Mutant> forgetful_mutants() {
  struct Forgotten {
    const char* what;
    Take take;
  };
  const Forgotten all[] = {
      {"known but for the border", [](Case& one, const Case& from) { one.border = from.border; }},
      {"known but for the addressing of u", [](Case& one, const Case& from) { one.wrap_u = from.wrap_u; }},
      {"known but for the addressing of v", [](Case& one, const Case& from) { one.wrap_v = from.wrap_v; }},
      {"known but for the filter", [](Case& one, const Case& from) { one.filter = from.filter; }},
      {"known but for the factor", [](Case& one, const Case& from) { one.factor = from.factor; }},
      {"known but for the vertices' factor",
       [](Case& one, const Case& from) { one.vertex_factor = from.vertex_factor; }},
      {"known but for the alpha mode", [](Case& one, const Case& from) { one.blend = from.blend; }},
      {"known but for the cutoff", [](Case& one, const Case& from) { one.cutoff = from.cutoff; }},
      {"known but for the margin", [](Case& one, const Case& from) { one.margin = from.margin; }},
      {"known but for the first vertex", [](Case& one, const Case& from) { one.uv[0] = from.uv[0]; }},
      {"known but for the last vertex", [](Case& one, const Case& from) { one.uv[5] = from.uv[5]; }},
  };
  std::vector<Mutant> mutants;
  for (const Forgotten& one : all) mutants.push_back(mutant(one.what, "bake", {0, 6}, forgetting(one.take)));
  return mutants;
}

}  // namespace mmverify::proofs::bake
