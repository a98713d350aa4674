#include "proofs/array/law_parts.hpp"

namespace mmverify::proofs::array {
namespace {

namespace maps = mmverify::spec::micromap;

}  // namespace

Law on_cases(Law law, std::vector<Entry> entries, Cases cases) {
  if (!law.how && law.method == Method::sample)
    law.how = [](const Subject&, Level) { return std::string("sample, by what a traversal reads"); };
  law.unfit = unless_of_topic<ArraySubject>(
      lacking<ArraySubject>(std::move(entries),
                            [levels = law.tiers.long_run, one_run = !law.at_once.empty()](
                                const ArraySubject&, Level n) -> std::optional<std::string> {
                              if (one_run || (levels.first <= n && n <= levels.last)) return std::nullopt;
                              return fmt::format("it is about levels {} to {}", levels.first, levels.last);
                            }));
  return on_cases_of(std::move(law), std::move(cases));
}

namespace {

Finding built_once(const ArraySubject& s, const BuildCase& c, Check check) {
  const std::optional<Answer> answer = s.functions.build(c);
  if (auto found = shape(answer, c)) return *found;
  return check(*answer, c);
}

}  // namespace

Finding built(const ArraySubject& s, BuildCase c, Check check) {
  Finding found = built_once(s, c, check);
  if (!found.holds || !s.functions.gets_places) return found;
  c.scattered = true;
  const Finding again = built_once(s, c, check);
  if (again.holds) return found;
  const Words words = again.words();
  return wrong(words.expected, words.got + ", with its maps from the last to the first");
}

Law on_small_arrays(Law law, Check check) {
  law.method = Method::exhaustive;
  law.tiers.fast = law.tiers.long_run = {0, 1};
  law.domain = [](const Subject&, Level n) -> std::string {
    if (n == 0)
      return "all arrays of up to 3 triangles of level 0, both formats, every choice, indices of 8, 16 and "
             "32 bits";
    return "all arrays of 1 and 2 triangles of levels 0 and 1, both formats, indices of 8, 16 and 32 bits; "
           "of the sorted maps those of 1 and 2 with every choice, and those of 3";
  };
  return on_cases(std::move(law), {entry::build},
                  {[](Level n) { return n > 1 ? 0 : small_arrays(n); },
                   [check](const ArraySubject& s, Level n, std::uint64_t k, const Run&) {
                     return built(s, small_array(n, k), check);
                   },
                   [](Level n, std::uint64_t k, const Run&) { return text_of(small_array(n, k)); },
                   [check](const ArraySubject& s, Level, const std::string& at) {
                     return built(s, case_of(at), check);
                   }});
}

std::function<void(Functions&)> answering(void (*spoil)(const BuildCase&, Answer&)) {
  return spoils(&Functions::build, [spoil](const BuildCase& c, std::optional<Answer>& a) {
    if (a) spoil(c, *a);
  });
}

std::function<void(Functions&)> building(void (*change)(BuildCase&)) {
  return [change](Functions& f) {
    f.build = [change, real = f.build](const BuildCase& c) {
      BuildCase other = c;
      change(other);
      return real(other);
    };
  };
}

std::uint32_t code_of(const Answer& a, const BuildCase& c, std::size_t t) {
  return maps::code_at(a.indices, c.options.encoding, maps::width(c.options.encoding) / 8, t);
}

void set_code(Answer& a, const BuildCase& c, std::size_t t, std::uint32_t code) {
  const std::size_t size = maps::width(c.options.encoding) / 8;
  for (std::size_t j = 0; j < size; ++j) a.indices[t * size + j] = static_cast<std::uint8_t>(code >> 8 * j);
}

std::function<std::string(const Subject&, Level)> named_domain(std::string text) {
  return [text = std::move(text)](const Subject&, Level) { return text; };
}

}  // namespace mmverify::proofs::array
