#include "proofs/index/ties.hpp"

#include <fmt/ranges.h>

#include "proofs/index/diagnosis.hpp"

namespace mmverify::proofs::index {

std::string rule_of_ties(const IndexSubject& subject, Level n) {
  const std::int64_t all = 4 * std::int64_t{side(n)};
  bool diagonal = false, of_u = false, of_v = false;
  for (const WrongCell& cell : wrong_cells(subject, n, Order::curve, whole_level(n)).listed) {
    if (cell.ku + cell.kv == all) continue;  // the base triangle's own edge, which has one side
    const bool on_u = cell.ku % 4 == 0, on_v = cell.kv % 4 == 0;
    if (on_u && on_v) continue;  // a vertex follows from its edges
    diagonal = diagonal || (!on_u && !on_v && (cell.ku + cell.kv) % 4 == 0);
    of_u = of_u || (on_u && cell.ku != 0);
    of_v = of_v || (on_v && cell.kv != 0);
  }
  std::vector<std::string> rules;
  if (diagonal)
    rules.emplace_back("where uf + vf = 1 the upper micro-triangle owns the point, so test uf + vf >= 1");
  if (of_u || of_v)
    rules.push_back(
        fmt::format("where {} = 0 the square of the greater {} owns it, so take the floor of 2^n {}",
                    of_u && of_v ? "uf or vf"
                    : of_u       ? "uf"
                                 : "vf",
                    of_u && of_v ? "coordinate"
                    : of_u       ? "u"
                                 : "v",
                    of_u && of_v ? "u and 2^n v"
                    : of_u       ? "u"
                                 : "v"));
  if (rules.empty()) return "";
  return fmt::format("the rule: {}", fmt::join(rules, "; "));
}

}  // namespace mmverify::proofs::index
