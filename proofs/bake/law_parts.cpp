#include "proofs/bake/law_parts.hpp"

#include "proofs/kinds.hpp"

namespace mmverify::proofs::bake {
namespace {

constexpr Level highest_level = 12;

const BakeSubject& of_bake(const Subject& s) { return dynamic_cast<const BakeSubject&>(s); }

}  // namespace

Law on_cases(Law law, const Cases& cases, const Check& check, const Draw& draw,
             const std::function<std::optional<std::string>(const BakeSubject&)>& lacks) {
  law.topic = "bake";
  if (law.long_run == Levels{}) law.long_run = law.fast;
  law.unfit = [lacks](const Subject& s, Level n) -> std::optional<std::string> {
    const auto* subject = dynamic_cast<const BakeSubject*>(&s);
    if (subject == nullptr) return "not a subject of topic bake";
    if (n > highest_level) return fmt::format("bakers go up to level {}", highest_level);
    return lacks ? lacks(*subject) : std::nullopt;
  };
  NumberedCases by_number{
      cases.count,
      [cases, check](const Subject& s, Level n, std::uint64_t k, const Run& run) {
        return check(of_bake(s), cases.number(n, k, run.seed), n, k);
      },
      [cases](Level n, std::uint64_t k, const Run& run) { return text_of(cases.number(n, k, run.seed)); },
      [check](const Subject& s, Level n, const std::string& at) {
        return check(of_bake(s), case_from(at), n, std::nullopt);
      },
      cases.chunk,
      Kind::interior};
  if (draw)
    by_number.draw = [draw](const Subject& s, Level n, const std::string& at) {
      return draw(of_bake(s), case_from(at), n);
    };
  return on_numbered_cases(std::move(law), by_number);
}

}  // namespace mmverify::proofs::bake
