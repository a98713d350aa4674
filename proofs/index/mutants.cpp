#include "proofs/index/mutants.hpp"

namespace mmverify::proofs::index {

SubjectOfIndex built_in(const char* name) { return built_in_subject(name); }

Mutant single(const char* name, const char* base, Level level, std::int64_t ku, std::int64_t kv,
              std::uint32_t flip) {
  return {name, altered(name, built_in(base), only_at_point(level, ku, kv, level, flip)), {level, level}};
}

Mutant on_points(const char* name, const char* base, Levels levels,
                 std::function<std::uint32_t(Level, const GridPoint&, std::uint32_t)> change,
                 bool on_rationals) {
  return {name, altered(name, built_in(base), {std::move(change), {}, {}, on_rationals}), levels};
}

Mutant on_indices(const char* name, const char* base, Levels levels,
                  std::function<Corners(Level, std::uint32_t, Corners)> change) {
  return {name, altered(name, built_in(base), {{}, {}, std::move(change), true}), levels};
}

Mutant swapped_corners(const char* name, const char* base, Level level, std::uint32_t index) {
  return {name, altered(name, built_in(base), only_at_index(level, index)), {level, level}};
}

bool on_u_line(const GridPoint& p, Level n) {
  return times(side(n), p.u) == Fixed64(whole(times(side(n), p.u)));
}

std::vector<Mutant> wrong_on_cells(const char* base) {
  return {single("one vertex of level 7", base, 7, corner(7) / 2, corner(7) / 4),
          single("the v-corner of level 6, the last cell", base, 6, 0, corner(6)),
          on_points("u ties round down at level 5", base, {0, 5},
                    [base_subject = built_in(base)](Level n, const GridPoint& p, std::uint32_t answer) {
                      if (n != 5 || !on_u_line(p, n) || p.u == Fixed64(0) || p.u + p.v == Fixed64(1))
                        return answer;
                      const GridPoint left{Fixed64::from_raw(p.u.raw() - 1), p.v};
                      std::uint32_t rounded_down = 0;
                      base_subject->index(n, Batch{{&left, 1}, false}, {&rounded_down, 1});
                      return rounded_down;
                    }),
          on_points("children 0 and 2 change places below level 4", base, {0, 6},
                    [](Level n, const GridPoint&, std::uint32_t answer) {
                      return n > 4 && answer % 2 == 0 ? answer ^ 2 : answer;
                    })};
}

std::vector<Mutant> inconsistent_on_cells(const char* base) {
  std::vector<Mutant> mutants = wrong_on_cells(base);
  mutants.pop_back();
  return mutants;
}

}  // namespace mmverify::proofs::index
