#include "proofs/index/ties.hpp"

#include <fmt/ranges.h>

#include "proofs/index/diagnosis.hpp"

namespace mmverify::proofs::index {

std::string rule_of_ties(const IndexSubject& subject, Level n) {
  const std::int64_t all = 4 * std::int64_t{side(n)};
  bool diagonal = false, of_u = false, of_v = false, outer = false;
  for (const WrongCell& cell : wrong_cells(subject, n, Order::curve, whole_level(n)).listed) {
    const bool on_u = cell.ku % 4 == 0, on_v = cell.kv % 4 == 0;
    if (cell.ku + cell.kv == all) {  // the base triangle's own edge, which has one side
      outer = outer || !on_u;
      continue;
    }
    if (on_u && on_v) continue;  // a vertex follows from its edges
    diagonal = diagonal || (!on_u && !on_v && (cell.ku + cell.kv) % 4 == 0);
    of_u = of_u || (on_u && cell.ku != 0);
    of_v = of_v || (on_v && cell.kv != 0);
  }
  std::vector<std::string> rules;
  if (diagonal)
    rules.emplace_back("where uf + vf = 1 the upper micro-triangle owns the point, so test uf + vf >= 1");
  if (of_u)
    rules.emplace_back("where uf = 0 the square of the greater u owns it, so take the floor of 2^n u");
  if (of_v)
    rules.emplace_back("where vf = 0 the square of the greater v owns it, so take the floor of 2^n v");
  if (outer)
    rules.emplace_back(
        "on the edge u + v = 1 no upper micro-triangle is left, so the lower one owns the point");
  if (rules.empty()) return "";
  return fmt::format("the rule: {}", fmt::join(rules, "; "));
}

}  // namespace mmverify::proofs::index
