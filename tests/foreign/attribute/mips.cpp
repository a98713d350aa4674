// Mip chains and levels of detail.
// Source: Color and Attribute Micromaps, 4.4; docs/ATTRIBUTE.md, "Mips and level of detail".
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "tests/foreign/attribute/places.hpp"

namespace mmverify::tests::foreign::attribute {
namespace {

using proofs::attribute::ChainOf;
using proofs::attribute::LevelOfDetail;
using proofs::attribute::Mips;
using proofs::attribute::Rounding;

std::uint64_t divided(std::uint64_t sum, std::uint64_t count, Rounding rounding, Fault wrong) {
  const std::uint64_t q = sum / count, r = sum % count;
  switch (rounding) {
    case Rounding::truncate:
      if (wrong == mip_truncate_counts_up_at_255 && q == 254 && r == 3) return 255;
      return q;
    case Rounding::half_to_even:
      if (wrong == mip_half_to_odd && 2 * r == count) return q + (1 - q % 2);
      if (wrong == mip_half_to_even_of_sum && 2 * r == count) return q + (sum / 2) % 2;
      if (2 * r == count) return q + q % 2;
      return q + (2 * r > count);
    case Rounding::half_up:
    case Rounding::halves_up:
      if (wrong == mip_half_down && 2 * r == count) return q;
      if (wrong == mip_half_down_from_128 && 2 * r == count && q >= 128) return q;
      return q + (2 * r >= count);
  }
  throw std::logic_error("no rounding");
}

std::uint32_t code(std::uint32_t word, unsigned c) { return word >> 8 * c & 0xff; }

std::uint32_t parent(Rounding rounding, std::span<const std::uint32_t> children, Fault wrong) {
  std::uint32_t word = 0;
  for (unsigned c = 0; c < 4; ++c) {
    std::array<std::uint32_t, 4> x{};
    for (std::size_t k = 0; k < 4; ++k) x[k] = code(children[k], c);
    std::uint64_t mean = 0;
    if (rounding == Rounding::halves_up) {
      const auto half = [](std::uint32_t a, std::uint32_t b) { return (a + b + 1) / 2; };
      mean = half(half(x[0], x[1]), half(x[2], x[3]));
      if (wrong == mip_pairs_crossed) mean = half(half(x[0], x[2]), half(x[1], x[3]));
      if (wrong == mip_pairs_in_turn) mean = half(half(half(x[0], x[1]), x[2]), x[3]);
    } else {
      std::uint64_t sum = x[0] + x[1] + x[2] + x[3];
      if (wrong == mip_sum_in_8_bits_of_alpha && c == 3 && sum == 1020) sum = 0;
      if (wrong == mip_carries_between_codes && c == 2)
        sum +=
            code(children[0], 1) + code(children[1], 1) + code(children[2], 1) + code(children[3], 1) == 1020;
      mean = divided(sum, 4, rounding, wrong);
    }
    word |= static_cast<std::uint32_t>(mean) << 8 * c;
  }
  return word;
}

std::uint64_t face_levels(Level m) { return ((std::uint64_t{1} << 2 * m) - 1) / 3; }

void chain_of(Level n, Rounding rounding, ChainOf from, std::span<const std::uint32_t> base,
              std::span<std::uint32_t> chain, Fault wrong) {
  std::vector<std::uint32_t> above(base.begin(), base.end());
  std::vector<std::array<std::uint64_t, 4>> sums(base.size());
  for (std::size_t k = 0; k < base.size(); ++k)
    for (unsigned c = 0; c < 4; ++c) sums[k][c] = code(base[k], c);
  std::uint64_t count = 1;
  for (Level m = n; m-- > 0;) {
    const std::size_t size = std::size_t{1} << 2 * m;
    count *= 4;
    for (std::size_t k = 0; k < size; ++k) {
      for (unsigned c = 0; c < 4; ++c) {
        std::uint64_t sum = 0;
        for (std::size_t child = 0; child < 4; ++child) sum += sums[4 * k + child][c];
        if (wrong == chain_sums_in_16_bits) sum &= 0xffff;
        if (wrong == chain_sums_lose_a_bit_from_4 && n - m >= 4) sum &= ~std::uint64_t{0xff};
        sums[k][c] = sum;
      }
      std::array<std::uint32_t, 4> children{above[4 * k], above[4 * k + 1], above[4 * k + 2],
                                            above[4 * k + 3]};
      if (wrong == chain_children_at_a_stride_from_3 && m >= 2)
        for (std::size_t c = 0; c < 4; ++c) children[c] = above[k + c * size];
      if (wrong == chain_last_triangle_of_4 && m == 3 && k + 1 == size) children[3] = children[2];
      std::uint32_t word = 0;
      const bool exact = from == ChainOf::exact_sums && wrong != chain_exact_of_level_above;
      if (exact)
        for (unsigned c = 0; c < 4; ++c)
          word |= static_cast<std::uint32_t>(divided(sums[k][c], count, rounding, wrong)) << 8 * c;
      else
        word = parent(rounding, children, wrong);
      if (wrong == chain_drifts_by_a_code && m == 0 && n >= 4 && (word & 0xff) < 255) ++word;
      above[k] = word;
    }
    std::size_t place = face_levels(m);
    if (wrong == chain_finest_first_of_two && n == 2) place = m == 1 ? 0 : 4;
    std::copy_n(above.begin(), size, chain.begin() + static_cast<std::ptrdiff_t>(place));
  }
}

std::uint32_t vertex_source(VertexOrder order, std::uint32_t k, Level m, Level n, Fault wrong) {
  if (wrong == source_is_itself_in_w_minor && order == VertexOrder::w_minor && k < 3) return k;
  Vertex at = vertex_of(order, m, k, wrong);
  Level apart = n - m;
  if (wrong == source_stride_of_two && order != VertexOrder::bird && apart > 1) apart = 1;
  if (wrong == source_columns_at_level_m && order == VertexOrder::u_major && apart > 0 && m > 3)
    return index_of(order, m, at, wrong) << apart;
  if (wrong == source_bird_by_place_rounded && order == VertexOrder::bird && apart > 3 && m > 0)
    return index_of(order, n, {at.i << apart | 1u, at.j << apart}, wrong);
  at = {at.i << apart, at.j << apart};
  return index_of(order, n, at, wrong);
}

// ---- Level of detail

Level level_of(Level n, float cone, float triangle, Fault wrong) {
  if (wrong == lod_by_log2 && cone > 0 && triangle > 0)
    return static_cast<Level>(
        std::clamp(std::floor(0.5f * std::log2(triangle / cone)), 0.0f, static_cast<float>(n)));
  if (wrong == lod_zero_cone_is_coarse && cone == 0) return 0;
  if (wrong == lod_zero_by_zero_is_coarse && cone == 0 && triangle == 0) return 0;
  if (wrong == lod_flushes_subnormals && cone < 0x1p-126f) cone = 0;
  Level m = 0;
  while (m < n &&
         std::ldexp(static_cast<double>(cone), 2 * static_cast<int>(m + 1)) <= static_cast<double>(triangle))
    ++m;
  if (wrong == lod_strict) {
    m = 0;
    while (m < n &&
           std::ldexp(static_cast<double>(cone), 2 * static_cast<int>(m + 1)) < static_cast<double>(triangle))
      ++m;
  }
  if (wrong == lod_shrinks_in_binary32) {
    m = 0;
    for (float shrunk = triangle / 4; m < n && cone <= shrunk; shrunk /= 4) ++m;
  }
  if (wrong == lod_up_to_8) m = std::min<Level>(m, 8);
  if (wrong == lod_one_less_at_n_from_9 && n >= 9 && m == n) --m;
  return m;
}

LevelOfDetail detail(Level n, float cone, float triangle, Fault wrong) {
  const Level m = level_of(n, cone, triangle, wrong);
  if (cone == 0) return {m, 0};
  const double c = static_cast<double>(cone), t = static_cast<double>(triangle);
  if (wrong == blend_beyond_the_finest && m == n && n > 3)
    return {m, std::clamp(0.5 * std::log2(t / std::ldexp(c, 2 * static_cast<int>(m))), 0.0, 0.999)};
  if (m == n || c >= t) return {m, 0};
  const double rest = t / std::ldexp(c, 2 * static_cast<int>(m));
  double blend = 0.5 * std::log2(rest);
  if (wrong == blend_linear_in_area) blend = (rest - 1) / 3;
  if (wrong == blend_without_half) blend = std::min(0.999, std::log2(rest));
  if (wrong == blend_in_binary16) blend = std::round(blend * 2048) / 2048;
  if (wrong == blend_of_binary32_logs_from_6 && n >= 6)
    blend = static_cast<double>(0.5f * (std::log2(triangle) - std::log2(cone)) - static_cast<float>(m));
  return {m, std::clamp(blend, 0.0, 1 - 0x1p-40)};
}

}  // namespace

Mips mips_with(Fault wrong) {
  Mips f;
  f.face_mip = [=](Rounding rounding, std::span<const std::uint32_t> children,
                   std::span<std::uint32_t> parents) {
    for (std::size_t k = 0; k < parents.size(); ++k)
      parents[k] = parent(rounding, children.subspan(4 * k, 4), wrong);
    if (wrong == mip_tail_of_before && parents.size() > 8)
      for (std::size_t k = parents.size() / 8 * 8; k < parents.size(); ++k) parents[k] = parents[k - 1];
  };
  f.face_chain = [=](Level n, Rounding rounding, ChainOf from, std::span<const std::uint32_t> base,
                     std::span<std::uint32_t> chain) { chain_of(n, rounding, from, base, chain, wrong); };
  f.face_chain_size = [=](Level m) -> std::uint64_t {
    if (wrong == chain_size_in_float && m > 12)
      return static_cast<std::uint64_t>(static_cast<float>(face_levels(m)));
    if (wrong == chain_size_with_the_base && m == 16) return face_levels(m + 1);
    if (wrong == chain_size_of_level_0 && m == 0) return 1;
    return face_levels(m);
  };
  f.vertex_chain_size = [=](Level m) -> std::uint64_t {
    std::uint64_t sum = 0;
    for (Level l = 0; l < m; ++l) sum += vertices_of(l);
    if (wrong == vertex_chain_shares_corners && m > 4) sum -= 3 * (m - 1);
    if (wrong == vertex_chain_is_a_third_from_9 && m > 8) sum = vertices_of(m) / 3;
    return sum;
  };
  f.vertex_mip_source = [=](VertexOrder order, std::uint32_t k, Level m, Level n) {
    return vertex_source(order, k, m, n, wrong);
  };
  f.lod_level = [=](Level n, std::span<const float> cone, std::span<const float> triangle,
                    std::span<Level> out) {
    for (std::size_t k = 0; k < cone.size(); ++k) out[k] = level_of(n, cone[k], triangle[k], wrong);
  };
  f.lod = [=](Level n, float cone, float triangle) { return detail(n, cone, triangle, wrong); };
  return f;
}

}  // namespace mmverify::tests::foreign::attribute
