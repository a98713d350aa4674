// Topic index: the curve and row order by another hand, in exact numbers, and what is wrong with each.
#include "tests/foreign/inside/index.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace mmverify::tests::foreign {
namespace {

using namespace proofs::index;
using proofs::Levels;

/// Barycentrics to index in exact numbers, by Algorithm 4 or by Vulkan's formula.
class Exact : public Hand {
 public:
  Exact(Reading reading, bool formula, Fault fault, Level max_level = 16)
      : Hand(fault, Arithmetic::exact, max_level), reading_(reading), formula_(formula) {}

  /// The formula likes many rows at once.
  std::size_t batch() const { return formula_ ? std::size_t{1} << 16 : row_batch; }

  void index(Level n, Batch batch, std::span<std::uint32_t> out) const {
    if (batch.row) return along(n, batch.points, out);
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = at(whole_numbers(batch.points[t]), n);
  }

  void index(Level n, FloatBatch batch, std::span<std::uint32_t> out) const {
    for (std::size_t t = 0; t < out.size(); ++t) {
      const double u = std::ldexp(batch.u[t], 30), v = std::ldexp(batch.v[t], 30);
      if (u == std::floor(u) && v == std::floor(v))
        out[t] = at(Bary<std::int64_t>{static_cast<std::int64_t>(u), static_cast<std::int64_t>(v),
                                       std::int64_t{1} << 30},
                    n);
      else
        out[t] =
            at(Bary<Integer>{in_smallest_units(batch.u[t]), in_smallest_units(batch.v[t]), Integer(1) << 149},
               n);
    }
  }

  void index_rows(Level n, Level grid, std::span<const Row> rows, std::span<std::uint32_t> out) const {
    std::vector<GridPoint> points;
    for (const Row& row : rows) {
      points.clear();
      for (std::uint64_t t = 0; t < row.count; ++t) {
        GridPoint p = representative(row, t, grid);
        if (fault == "second_row_has_firsts_line"_fault && &row != rows.data() && row.kv % 4 == 1)
          p.v = coordinate(row.kv + 2, grid);
        points.push_back(p);
      }
      along(n, points, out.first(row.count));
      out = out.subspan(row.count);
    }
  }

  std::uint32_t index(Level n, const RationalPoint& p) const {
    Bary<Integer> b = whole_numbers(p);
    if ((fault == "through_binary64_at_16"_fault && n == 16) || fault == "rationals_cut_to_8_bits"_fault) {
      const int bits = n == 16 ? 53 : 8;
      b = {Integer((b.u << bits) / b.one), Integer((b.v << bits) / b.one), Integer(1) << bits};
    }
    return at(b, n);
  }

 private:
  template <class Int>
  std::uint32_t at(const Bary<Int>& p, Level n) const {
    if (formula_) return static_cast<std::uint32_t>(vulkan(p, n, fault));
    Reading reading = reading_;
    if (fault == "as_printed"_fault || (fault == "as_printed_from_level_6"_fault && n >= 6))
      reading = Reading::printed;
    if (fault == "as_printed_up_to_level_4"_fault && n <= 4) reading = Reading::printed;
    return static_cast<std::uint32_t>(recursion(p, n, reading, fault));
  }

  /// A row: from its first point on by its stride.
  void along(Level n, std::span<const GridPoint> row, std::span<std::uint32_t> out) const {
    if (row.empty()) return;
    Bary<std::int64_t> p = whole_numbers(row[0]);
    const std::int64_t stride = row.size() > 1 ? row[1].u.raw() - row[0].u.raw() : 0;
    if (fault == "cut_rows_start_anew"_fault && stride != 0) p.u %= stride;
    for (std::size_t t = 0; t < row.size(); ++t, p.u += stride) out[t] = at(p, n);
    if (fault == "tail_repeats"_fault && row.size() % 4 == 1 && row.size() > 1000)
      out[row.size() - 1] = out[row.size() - 2];
    if (fault == "skips_between_siblings"_fault && n >= 9)
      for (std::size_t t = 2; t < row.size(); t += 2)
        if (out[t] / 4 == out[t - 2] / 4) out[t - 1] = out[t - 2];
  }

  const Reading reading_;
  const bool formula_;
};

/// Vulkan's formula in 64-bit words.
class Wide : public Hand {
 public:
  explicit Wide(Fault fault) : Hand(fault, Arithmetic::exact, 16) {}
  static constexpr Level max_wide_level = 30;
  void index(Level n, Batch batch, std::span<std::uint32_t> out) const {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = static_cast<std::uint32_t>(vulkan(whole_numbers(batch.points[t]), n, fault));
  }
  std::uint32_t index(Level n, const RationalPoint& p) const {
    return static_cast<std::uint32_t>(wide_index(n, p));
  }
  void wide_index(Level n, const Row& row, std::span<std::uint64_t> out) const {
    const std::int64_t one = std::int64_t{4} << n;
    for (std::uint64_t t = 0; t < row.count; ++t) {
      std::int64_t ku = row.ku + static_cast<std::int64_t>(t) * row.stride;
      if (fault == "cut_rows_start_anew"_fault)
        ku = row.ku % row.stride + static_cast<std::int64_t>(t) * row.stride;
      out[t] = vulkan(Bary<std::int64_t>{ku, row.kv, one}, n, fault);
    }
  }
  std::uint64_t wide_index(Level n, const RationalPoint& p) const {
    return vulkan(whole_numbers(p), n, fault);
  }
};

/// Vulkan's formula as its 32-bit words run it, whatever the level.
class In32Bits : public Hand {
 public:
  explicit In32Bits(Fault fault) : Hand(fault, Arithmetic::exact, 17) {}
  static constexpr Level max_wide_level = 17;
  std::uint64_t wide_index(Level n, const RationalPoint& p) const { return index(n, p); }
  void wide_index(Level n, const Row& row, std::span<std::uint64_t> out) const {
    for (std::uint64_t t = 0; t < row.count; ++t) out[t] = at(whole_numbers(representative(row, t, n)), n);
  }
  void index(Level n, Batch batch, std::span<std::uint32_t> out) const {
    for (std::size_t t = 0; t < out.size(); ++t) out[t] = at(whole_numbers(batch.points[t]), n);
  }
  std::uint32_t index(Level n, const RationalPoint& p) const { return at(whole_numbers(p), n); }

 private:
  template <class Int>
  std::uint32_t at(const Bary<Int>& p, Level n) const {
    if (fault == "low_half_of_wide"_fault) return static_cast<std::uint32_t>(vulkan(p, n, Fault::none));
    if (fault == "recursion_instead"_fault)
      return static_cast<std::uint32_t>(recursion(p, n, Reading::printed, Fault::none));
    const std::uint32_t N = std::uint32_t{1} << n;
    const Int scaled_u = p.u * N, scaled_v = p.v * N;
    std::uint32_t iu = std::min(static_cast<std::uint32_t>(scaled_u / p.one), N - 1);
    const std::uint32_t iv = std::min(static_cast<std::uint32_t>(scaled_v / p.one), N - 1), s = iu + iv;
    if (s >= N) iu -= s - N + 1;
    std::uint32_t iw = ~(iu + iv);
    if (scaled_u % p.one + scaled_v % p.one >= p.one && s < N - 1) --iw;
    const std::uint32_t low = N - 1, b0 = ~(iu ^ iw) & low, t = (iu ^ iv) & b0;
    std::uint32_t f = t;
    for (unsigned by = 1; by < (fault == "parity_of_all_places"_fault ? 32 : 16); by *= 2) f ^= f >> by;
    // Words of 17 bits do not fit the interleaving, whose lowest 32 bits are right without their highest.
    const std::uint32_t kept = fault == "parity_of_all_places"_fault ? 0xFFFF : low;
    return apart(b0 & kept) | apart((((f ^ iu) & ~b0) | t) & kept) << 1;
  }
  static std::uint32_t apart(std::uint32_t x) {
    x = (x | x << 8) & 0x00FF00FF;
    x = (x | x << 4) & 0x0F0F0F0F;
    x = (x | x << 2) & 0x33333333;
    return (x | x << 1) & 0x55555555;
  }
};

/// Figure 4: rows from the w-corner.
class RowOrder : public Hand {
 public:
  explicit RowOrder(Fault fault) : Hand(fault, Arithmetic::exact, 16) {}

  void row_index(Level n, Batch batch, std::span<std::uint32_t> out) const {
    for (std::size_t t = 0; t < out.size(); ++t)
      out[t] = at(n, batch.points[t].u.raw(), batch.points[t].v.raw());
  }

  void row_corners(Level n, std::span<const std::uint32_t> indices, std::span<Corners> out) const {
    const std::uint64_t last_float_square = 4097;
    for (std::size_t t = 0; t < out.size(); ++t) {
      const std::uint32_t index = indices[t];
      auto root = static_cast<std::uint32_t>(std::sqrt(static_cast<float>(index)));
      if (fault == "errs_one_index_later"_fault && index <= last_float_square * last_float_square - 2)
        root = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(index)));
      if (fault == "root_is_low_at_squares"_fault && root * root == index && root == 1023) --root;
      std::uint32_t column = index - root * root;
      if (fault == "one_column_off"_fault && n == 10 && index == 777'777) ++column;
      const auto vertex = [](std::uint32_t r, std::uint32_t c) { return spec::index::Vertex{r - c, c}; };
      const std::uint32_t half = column / 2;
      if (column % 2 == 0)
        out[t] = {vertex(root, half), vertex(root + 1, half), vertex(root + 1, half + 1)};
      else
        out[t] = {vertex(root, half), vertex(root + 1, half + 1), vertex(root, half + 1)};
    }
  }

 private:
  std::uint32_t at(Level n, std::int64_t u, std::int64_t v) const {
    const std::int64_t one = std::int64_t{1} << 30, N = std::int64_t{1} << n;
    const auto row = std::min(N - 1, (u + v) * N / one);
    auto column = v * N / one, diagonal = (one - u) * N / one;
    if (fault != "column_not_limited"_fault) column = std::min(row, column);
    if (fault != "diagonal_not_limited"_fault) diagonal = std::min(N - 1, diagonal);
    auto square = row * row;
    if (fault == "row_squared_in_16_bits"_fault) square &= 0xFFFF;
    const auto index = square + column + (diagonal - (N - 1 - row));
    if (fault == "one_inverted_triangle"_fault && n == 8 && index == 40'001) return 40'000;
    return static_cast<std::uint32_t>(index);
  }
};

InsideFault steps(const char* law, const char* name, const char* wrong, Levels levels,
                  Reading reading = Reading::printed) {
  return fault<Exact>(law, name, wrong, levels, reading, false, named(name));
}
InsideFault formula(const char* law, const char* name, const char* wrong, Levels levels) {
  return fault<Exact>(law, name, wrong, levels, Reading::printed, true, named(name));
}
InsideFault wide(const char* law, const char* name, const char* wrong, Levels levels) {
  return fault<Wide>(law, name, wrong, levels, named(name));
}
InsideFault narrow(const char* law, const char* name, const char* wrong) {
  return fault<In32Bits>(law, name, wrong, {17, 17}, named(name));
}
InsideFault rows(const char* law, const char* name, const char* wrong, Levels levels) {
  return fault<RowOrder>(law, name, wrong, levels, named(name));
}

InsideRows faults_of_step() {
  return {steps("paper.step_equals_reference", "turned_t_keeps_tie",
                "from depth 5 on, T takes the tie on a middle triangle that is flipped at its top", {0, 10}),
          steps("paper.step_equals_reference", "top_flip_lost_at_depth_7",
                "at depth 7, T does not flip on a middle triangle", {0, 10}),
          steps("paper.step_equals_reference", "w_tie_at_depth_8", "at depth 8, w = 1/2 is the w-corner's",
                {0, 10}),
          steps("paper.step_equals_reference", "one_triangle_of_level_9",
                "one index of level 9 is that of its neighbour", {0, 10})};
}

/// The three that follow the print where the appendix differs.
InsideRows faults_of_appendix() {
  InsideRows all;
  for (const auto& [id, reading] : {std::pair{"paper.appendix_middle_differs", Reading::middle},
                                    std::pair{"paper.appendix_ties_differ", Reading::ties},
                                    std::pair{"paper.appendix_names_differ", Reading::names}}) {
    all.push_back(steps(id, "as_printed", "it follows the print", {0, 7}, reading));
    all.push_back(
        steps(id, "as_printed_from_level_6", "it follows the print from level 6 on", {0, 7}, reading));
    all.push_back(
        steps(id, "as_printed_up_to_level_4", "it follows the print up to level 4", {0, 7}, reading));
  }
  return all;
}

InsideRows faults_of_index() {
  return {steps("index.cells_decide", "line_moved_in_some_cells",
                "in one parent of 64, the last line is a 64th off the grid's", {0, 16}),
          steps("index.cells_decide", "through_binary64_at_16",
                "at level 16, the point is rounded down to 53 bits", {0, 16}),
          steps("index.cells_decide", "ties_of_odd_denominators",
                "a tie is not seen where a denominator is no power of two", {0, 16}),
          formula("index.fixed_is_rational", "product_of_32_bits",
                  "uN is formed in 32 bits of which 24 are the fraction's", {0, 8}),
          steps("index.fixed_is_rational", "rationals_cut_to_8_bits",
                "rational points are rounded down to 8 bits", {8, 8}),
          steps("index.fixed_is_rational", "fixed_u_tie_at_depth_7",
                "at depth 7, fixed point leaves u = 1/2 to the middle", {0, 8}),
          steps("index.sweep_is_spec", "tail_repeats",
                "the last point of a row of more than 1000 gets the answer before it", {10, 10}),
          steps("index.sweep_is_spec", "cut_rows_start_anew",
                "a row that is cut is answered from its uncut start", {0, 10}),
          steps("index.sweep_is_spec", "skips_between_siblings",
                "from level 9 on, a point between two siblings is taken for the first", {0, 10}),
          formula("index.sweep_is_spec", "second_row_has_firsts_line",
                  "rows after the first lie half a line too high", {0, 10})};
}

InsideRows faults_of_wide_index() {
  return {
      wide("index.wide_equals_reference", "answer_of_16_bits", "digits above the eighth are lost", {0, 9}),
      wide("index.wide_equals_reference", "parity_of_8_places", "the prefix XOR reaches over 8 places",
           {0, 9}),
      wide("index.wide_equals_reference", "v_corner_not_limited", "at level 9, iv is N in the v-corner",
           {0, 9}),
      wide("index.wide_equals_reference", "half_of_last_square",
           "in one square beside the hypotenuse's, the diagonal is the lower half's", {0, 9}),
      wide("index.wide_equals_reference", "cut_rows_start_anew",
           "a row that is cut is answered from its uncut start", {0, 9}),
      wide("index.wide_exact_on_floats", "parity_of_16_places", "the prefix XOR reaches over 16 places",
           {17, 30}),
      wide("index.wide_exact_on_floats", "answer_through_binary64", "the index passes through binary64",
           {27, 30}),
      wide("index.wide_exact_on_floats", "limit_in_binary32", "N-1 is rounded to binary32", {25, 30}),
      wide("index.wide_exact_on_floats", "sum_in_binary32", "the sum of the fractions is rounded to binary32",
           {17, 30}),
      wide("index.wide_exact_on_floats", "low_digit_at_level_30",
           "at level 30, upper halves have another lowest digit where iv > iu", {30, 30})};
}

InsideRows faults_of_32_bits() {
  return {narrow("index.vulkan_ends_at_16", "parity_of_all_places",
                 "the prefix XOR reaches over all places, and what does not fit is cut off"),
          narrow("index.vulkan_ends_at_16", "low_half_of_wide", "it gives the low half of the right index"),
          narrow("index.vulkan_ends_at_16", "recursion_instead", "it runs the recursion")};
}

InsideRows faults_of_row_order() {
  return {
      rows("paper.w_minor_holds_point", "column_not_limited", "the column is not limited to the row", {0, 9}),
      rows("paper.w_minor_holds_point", "diagonal_not_limited", "the diagonal is not limited to N-1", {0, 9}),
      rows("paper.w_minor_holds_point", "row_squared_in_16_bits", "the row's square keeps 16 bits", {0, 9}),
      rows("paper.w_minor_holds_point", "one_inverted_triangle",
           "one inverted triangle of level 8 is taken for its neighbour", {0, 9}),
      rows("paper.w_minor_binary32_root_errs", "root_is_low_at_squares", "the root of 1023^2 is 1022",
           {10, 13}),
      rows("paper.w_minor_binary32_root_errs", "errs_one_index_later",
           "the first root that errs is one index later", {13, 13}),
      rows("paper.w_minor_binary32_root_errs", "one_column_off", "one index of level 10 has the next column",
           {10, 13})};
}

}  // namespace

std::vector<InsideFault> inside_right_of_index() {
  std::vector<InsideFault> all;
  const auto add = [&all](InsideFault f) { all.push_back(std::move(f)); };
  const Fault none = Fault::none;
  for (const bool formula : {false, true}) {
    add(fault<Exact>("index.cells_decide", formula ? "formula" : "steps", "", {0, 16}, Reading::printed,
                     formula, none));
    add(fault<Exact>("index.fixed_is_rational", formula ? "formula" : "steps", "", {0, 6}, Reading::printed,
                     formula, none));
    add(fault<Exact>("index.sweep_is_spec", formula ? "formula" : "steps", "", {0, 9}, Reading::printed,
                     formula, none));
  }
  add(fault<Exact>("paper.step_equals_reference", "steps", "", {0, 9}, Reading::printed, false, none));
  add(fault<Exact>("paper.appendix_middle_differs", "middle", "", {0, 7}, Reading::middle, false, none));
  add(fault<Exact>("paper.appendix_ties_differ", "ties", "", {0, 7}, Reading::ties, false, none));
  add(fault<Exact>("paper.appendix_names_differ", "names", "", {0, 7}, Reading::names, false, none));
  add(fault<Wide>("index.wide_equals_reference", "formula", "", {0, 9}, none));
  add(fault<Wide>("index.wide_exact_on_floats", "formula", "", {28, 30}, none));
  add(fault<In32Bits>("index.vulkan_ends_at_16", "formula", "", {17, 17}, none));
  add(fault<RowOrder>("paper.w_minor_holds_point", "rows", "", {0, 9}, none));
  add(fault<RowOrder>("paper.w_minor_binary32_root_errs", "rows_below", "", {10, 10}, none));
  add(fault<RowOrder>("paper.w_minor_binary32_root_errs", "rows", "", {13, 13}, none));
  for (InsideFault& f : right_rounding()) add(std::move(f));
  return all;
}

InsideRows inside_faults_of_index() {
  InsideRows all;
  for (const auto& some : {faults_of_step(), faults_of_appendix(), faults_of_index(), faults_of_wide_index(),
                           faults_of_32_bits(), faults_of_row_order(), faults_of_rounding()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace mmverify::tests::foreign
