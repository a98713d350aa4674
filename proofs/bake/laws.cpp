#include "proofs/bake/laws.hpp"

#include "proofs/bake/law_parts.hpp"

namespace mmverify::proofs::bake {

std::vector<Law> laws() {
  std::vector<Law> all = state_laws();
  all.push_back(large_law());
  for (const auto& group : {relation_laws(), changing_laws(), mesh_laws()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

namespace {

constexpr Level highest_level = 12;

}  // namespace

Law on_cases(Law law, const Cases& cases, const Check& check, const Draw& draw, const Lacks& lacks) {
  if (law.tiers.long_run == Levels{}) law.tiers.long_run = law.tiers.fast;
  law.unfit =
      unless_of_topic<BakeSubject>([lacks](const BakeSubject& s, Level n) -> std::optional<std::string> {
        if (!s.functions.bake) return s.name() + " has no entry point bake";
        if (n > highest_level) return fmt::format("bakers go up to level {}", highest_level);
        const Support& support = s.functions.support;
        if (n > support.max_level) return fmt::format("it declares levels up to {}", support.max_level);
        if (!support.four_state) return "it declares no maps in 4-state";
        return lacks ? lacks(s, n) : std::nullopt;
      });
  law.domain = [domain = law.domain](const Subject& s, Level n) {
    const auto* subject = dynamic_cast<const BakeSubject*>(&s);
    std::string text = domain(s, n);
    if (subject != nullptr && !subject->functions.support.whole())
      text += "; within what it declares: " + subject->functions.support.text();
    return text;
  };
  const auto count = [cases, sampled = law.method == Method::sample, first = law.tiers.fast.first](
                         Level n, const Run& run) {
    constexpr Level lowest = 4;  // among so many levels the cases asked for are spread
    const std::uint64_t of_tier = cases.count(n, run);
    const bool more = sampled && run.cases != 0 && n >= first && n < first + lowest;
    return more ? std::max(of_tier, (run.cases + lowest - 1) / lowest) : of_tier;
  };
  NumberedCases by_number{
      count,
      [cases, check](const Subject& s, Level n, std::uint64_t k, const Run& run) {
        return check(subject_as<BakeSubject>(s),
                     cases.number(subject_as<BakeSubject>(s).functions.support, n, k, run.seed), n, k);
      },
      [cases](const Subject& s, Level n, std::uint64_t k, const Run& run) {
        return text_of(cases.number(subject_as<BakeSubject>(s).functions.support, n, k, run.seed));
      },
      [check](const Subject& s, Level n, const std::string& at) {
        return check(subject_as<BakeSubject>(s), case_from(at), n, std::nullopt);
      },
      cases.chunk,
      Kind::interior};
  if (draw)
    by_number.draw = [draw](const Subject& s, Level n, const std::string& at) {
      return draw(subject_as<BakeSubject>(s), case_from(at), n);
    };
  return on_numbered_cases(std::move(law), by_number);
}

}  // namespace mmverify::proofs::bake
