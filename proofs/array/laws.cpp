#include "proofs/array/laws.hpp"

#include "proofs/array/law_parts.hpp"
#include "proofs/array/small_answers.hpp"

namespace mmverify::proofs::array {

std::vector<Law> laws() {
  std::vector<Law> all;
  for (const auto& group :
       {build_laws(), order_laws(), merge_laws(), index_laws(), change_laws(), file_laws(), device_laws()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

namespace {

namespace maps = mmverify::spec::micromap;

using AnyCheck = std::function<Finding(const Answer&, const BuildCase&)>;

Finding built_once(const ArraySubject& s, const BuildCase& c, const AnyCheck& check) {
  const std::optional<Answer> answer = s.functions.build(c);
  if (auto found = shape(answer, c)) return *found;
  return check(*answer, c);
}

}  // namespace

Law on_cases(Law law, std::vector<Entry> entries, Cases cases) {
  if (!law.how && law.method == Method::sample) law.how = "sample, by what a traversal reads";
  law.unfit = unless_of_topic<ArraySubject>(
      lacking<ArraySubject>(std::move(entries),
                            [levels = law.tiers.long_run, one_run = !law.at_once.empty()](
                                const ArraySubject&, Level n) -> std::optional<std::string> {
                              if (one_run || (levels.first <= n && n <= levels.last)) return std::nullopt;
                              return fmt::format("it is about levels {} to {}", levels.first, levels.last);
                            }));
  return on_cases_of(std::move(law), std::move(cases));
}

Finding built(const ArraySubject& s, BuildCase c, const AnyCheck& check) {
  Finding found = built_once(s, c, check);
  if (!found.holds || !s.functions.gets_places) return found;
  c.scattered = true;
  const Finding again = built_once(s, c, check);
  if (again.holds) return found;
  const Words words = again.words();
  return wrong(words.expected, words.got + ", with its maps from the last to the first");
}

Cases built_cases(CaseCount count, std::function<BuildCase(Level, std::uint64_t k)> number, Check check,
                  std::uint64_t chunk) {
  return {std::move(count),
          [=](const ArraySubject& s, Level n, std::uint64_t k, const Run&) {
            return built(s, number(n, k), check);
          },
          [=](Level n, std::uint64_t k, const Run&) { return text_of(number(n, k)); },
          [=](const ArraySubject& s, Level, const std::string& at) { return built(s, case_of(at), check); },
          chunk};
}

Cases drawn_cases(CaseCount count, SampleCheck check, std::uint64_t chunk) {
  return {std::move(count),
          [=](const ArraySubject& s, Level n, std::uint64_t k, const Run& run) {
            return check(s, n, run.seed, k);
          },
          [](Level, std::uint64_t k, const Run& run) { return text_of_sample(run.seed, k); },
          [=](const ArraySubject& s, Level n, const std::string& at) {
            const auto [seed, k] = sample_of(at);
            return check(s, n, seed, k);
          },
          chunk};
}

Law on_small_arrays(Law law, Check check) {
  law.tiers.fast = law.tiers.long_run = {0, 1};
  law.domain = [](Level n) -> std::string {
    if (n == 0)
      return "all arrays of up to 3 triangles of level 0, both formats, every choice, indices of 8, 16 and "
             "32 bits";
    return "all arrays of 1 and 2 triangles of levels 0 and 1, both formats, indices of 8, 16 and 32 bits; "
           "of the sorted maps those of 1 and 2 with every choice, and those of 3";
  };
  Cases cases = built_cases([](Level n) { return n > 1 ? 0 : small_arrays(n); }, small_array, check);
  cases.check = [check](const ArraySubject& s, Level n, std::uint64_t k, const Run&) {
    return small_array_finding(s, n, k, check);
  };
  return on_cases(std::move(law), {entry::build}, std::move(cases));
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

}  // namespace mmverify::proofs::array
