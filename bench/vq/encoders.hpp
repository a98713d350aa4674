// The list of all encoders, and sums of one encoder's figures over all maps.
#pragma once

#include <vector>

#include "bench/vq/bench.hpp"

namespace mmverify::bench {

inline constexpr Vq2Encoder all_vq2[] = {Vq2Encoder::paper, Vq2Encoder::paper_highest_first,
                                         Vq2Encoder::optimal};
inline constexpr Vq4Encoder all_vq4[] = {Vq4Encoder::paper,    Vq4Encoder::paper_free_c, Vq4Encoder::fast,
                                         Vq4Encoder::balanced, Vq4Encoder::thorough,     Vq4Encoder::proved};

inline double states_of(const VqRow& row, Vq2Encoder) { return row.states_16; }
inline double states_of(const VqRow& row, Vq4Encoder) { return row.states_32; }
/// The fewest substitutions that a block can have.
inline std::uint32_t bound_of(const VqRow& row, Vq2Encoder) {
  return row.by(Vq2Encoder::optimal).substitutions;
}
inline std::uint32_t bound_of(const VqRow& row, Vq4Encoder) { return row.least; }

/// The sum of figure(row) over all maps.
template <class Figure>
double sum_over(const std::vector<VqRow>& rows, const Figure& figure) {
  double sum = 0;
  for (const VqRow& row : rows) sum += figure(row);
  return sum;
}
template <class Figure>
double mean_over(const std::vector<VqRow>& rows, const Figure& figure) {
  return sum_over(rows, figure) / static_cast<double>(rows.size());
}

/// 100 part / whole; 0 if the whole is 0.
inline double per_cent_of(double part, double whole) { return whole > 0 ? 100 * part / whole : 0; }

}  // namespace mmverify::bench
