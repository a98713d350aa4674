// Source: Color and Attribute Micromaps, 3.1; docs/ATTRIBUTE.md, "Orders"; docs/INDEX.md for the curve.
#include "tests/foreign/attribute/places.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <unordered_map>

namespace mmverify::tests::foreign::attribute {
namespace {

std::uint64_t root_of(std::uint64_t x) {
  auto r = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(x)));
  while (r * r > x) --r;
  while ((r + 1) * (r + 1) <= x) ++r;
  return r;
}

/// The greatest r with r(r+1)/2 <= x.
std::uint64_t row_of(std::uint64_t x) { return (root_of(8 * x + 1) - 1) / 2; }

// ---- The curve, by descent from the base triangle

enum Child { at_w, middle, at_u, at_v };

/// One way down: which end the curve enters at, and how the triangle stands.
struct Path {
  bool turned = false, upright = true;
  std::uint64_t index = 0, uprights = 0;  ///< before it

  /// Domain: a child of a triangle of `l` + 1 levels.
  void enter(unsigned digit, Level l, Fault wrong) {
    const std::uint64_t S = side_of(l), more = S * (S + 1) / 2, fewer = S * (S - 1) / 2;
    for (unsigned before = 0; before < digit; ++before) uprights += (before == 1) != upright ? more : fewer;
    index = 4 * index + digit;
    if (digit == 1) upright = !upright;
    if (digit == 1 || digit == 3) turned = !turned;
    if (wrong == curve_turn_lost_at_seventh && l == 6 && digit == 3) turned = !turned;
  }
};

unsigned digit_of(Child child, bool turned) {
  switch (child) {
    case at_w: return turned ? 2 : 0;
    case at_u: return turned ? 0 : 2;
    case middle: return 1;
    case at_v: return 3;
  }
  return 0;
}

Path path_to(MicroTriangle t, Level n, Fault wrong) {
  Path path;
  for (Level l = n; l-- > 0;) {
    const std::uint32_t h = side_of(l);
    Child child = middle;
    if (t.iu + t.iv + (t.upper ? 1 : 0) < h) {
      child = at_w;
    } else if (t.iu >= h) {
      child = at_u, t.iu -= h;
    } else if (t.iv >= h) {
      child = at_v, t.iv -= h;
    } else {
      t = {h - 1 - t.iu, h - 1 - t.iv, !t.upper};
    }
    unsigned digit = digit_of(child, path.turned);
    if (wrong == curve_first_digit_at_8 && n == 8 && l == 7 && digit != 1) digit = digit == 3 ? 3 : 2 - digit;
    path.enter(digit, l, wrong);
  }
  return path;
}

MicroTriangle on_curve(std::uint64_t x, Level n, Fault wrong) {
  Path path;
  // The base of the triangle, and in which direction its sides go.
  std::int64_t i = 0, j = 0, way = 1;
  for (Level l = n; l-- > 0;) {
    const auto digit = static_cast<unsigned>(x >> (2 * l) & 3);
    const std::int64_t step = way * static_cast<std::int64_t>(side_of(l));
    if (digit == 3) {
      j += step;
    } else if (digit == 1) {
      i += step, j += step;
      way = -way;
    } else if ((digit == 2) != path.turned) {
      i += step;
    }
    path.enter(digit, l, wrong);
  }
  const bool upper = way < 0;
  return {static_cast<std::uint32_t>(upper ? i - 1 : i), static_cast<std::uint32_t>(upper ? j - 1 : j),
          upper};
}

// ---- Bird

std::uint64_t bird(Level n, const Vertex& at, Fault wrong) {
  const std::uint32_t N = side_of(n), k = N - at.i - at.j;
  const bool exchanged =
      (wrong == bird_corners_uv_at_6 && n == 6) || (wrong == bird_corners_uv_at_16 && n == 16);
  if (k == N) return 0;
  if (at.i == N) return exchanged ? 2 : 1;
  if (at.j == N) return exchanged ? 1 : 2;
  Level coarser = static_cast<Level>(std::countr_zero(at.i | at.j | k));
  if (wrong == bird_twos_of_i_alone && at.i != 0) coarser = static_cast<Level>(std::countr_zero(at.i));
  if (wrong == bird_by_own_level) coarser = 0;
  const Level m = n - coarser;
  const std::uint32_t i = at.i >> coarser, j = at.j >> coarser;
  std::uint64_t edge = i % 2 == 0 ? 0 : j % 2 == 1 ? 1 : 2;
  if (wrong == bird_triplet_from_the_next_edge) edge = (edge + 1) % 3;
  if (wrong == bird_edges_exchanged_from_5 && n >= 5 && m >= 5 && edge != 2) edge = 1 - edge;
  const std::uint64_t rank = path_to({i / 2, j / 2, false}, m - 1, wrong).uprights;
  if (wrong == bird_last_triplet_at_7 && m == 7 && rank + 1 == 64 * 65 / 2) edge = 2 - edge;
  if (wrong == bird_rank_in_16_bits) return vertices_of(m - 1) + static_cast<std::uint16_t>(3 * rank + edge);
  return vertices_of(m - 1) + 3 * rank + edge;
}

Vertex bird_vertex(Level n, std::uint64_t x, Fault wrong) {
  const std::uint32_t N = side_of(n);
  if (x < 3) return x == 0 ? Vertex{0, 0} : x == 1 ? Vertex{N, 0} : Vertex{0, N};
  Level m = 1;
  while (vertices_of(m) <= x) ++m;
  std::uint64_t rank = (x - vertices_of(m - 1)) / 3;
  std::uint64_t edge = (x - vertices_of(m - 1)) % 3;
  std::uint64_t curve = 0;
  bool upright = true;
  for (Level l = m - 1; l-- > 0;) {
    const std::uint64_t S = side_of(l);
    for (unsigned digit = 0;; ++digit) {
      const bool stands = (digit == 1) != upright;
      const std::uint64_t held = stands ? S * (S + 1) / 2 : S * (S - 1) / 2;
      if (rank < held) {
        curve = 4 * curve + digit;
        upright = stands;
        break;
      }
      rank -= held;
    }
  }
  if (wrong == bird_back_edges_at_9 && m == 9 && edge > 0) edge = 3 - edge;
  const MicroTriangle t = on_curve(curve, m - 1, wrong);
  const std::uint32_t i = 2 * t.iu + (edge != 0), j = 2 * t.iv + (edge != 2);
  const Level coarser = wrong == bird_back_at_own_level && m + 6 < n ? n - m - 1 : n - m;
  return {i << coarser, j << coarser};
}

}  // namespace

// ---- Vertices

std::uint32_t index_of(VertexOrder order, Level n, const Vertex& at, Fault wrong) {
  const std::uint64_t i = at.i, j = at.j, N = side_of(n);
  switch (order) {
    case VertexOrder::w_minor: {
      const std::uint64_t r = i + j;
      if (wrong == w_minor_in_32_bits) {
        const auto r32 = static_cast<std::uint32_t>(r);
        return r32 * (r32 + 1) / 2 + at.j;
      }
      if (wrong == w_minor_rows_in_16_bits) return static_cast<std::uint16_t>(r * (r + 1) / 2) + at.j;
      if (wrong == w_minor_backwards_from_6 && n >= 6) return static_cast<std::uint32_t>(r * (r + 1) / 2 + i);
      if (wrong == w_minor_from_the_u_end) return static_cast<std::uint32_t>(r * (r + 1) / 2 + i);
      if (wrong == w_minor_last_row_at_9 && n == 9 && r == N && j % 2 == 1)
        return static_cast<std::uint32_t>(r * (r + 1) / 2 + r - j);
      if (wrong == w_minor_v_end_at_8 && n == 8 && i == 0 && j > 0 && j < N)
        return static_cast<std::uint32_t>(r * (r + 1) / 2 + j + 1);
      return static_cast<std::uint32_t>(r * (r + 1) / 2 + j);
    }
    case VertexOrder::u_major: {
      std::uint64_t before = i * (2 * N + 3 - i) / 2;
      if (wrong == u_major_in_32_bits)
        before =
            static_cast<std::uint32_t>(at.i * (static_cast<std::uint32_t>(N) + 2) - at.i * (at.i + 1) / 2);
      if (wrong == u_major_columns_of_faces) before = i * (2 * N + 1 - i) / 2;
      if (wrong == u_major_last_column_from_5 && n >= 5 && i == N) --before;
      if (wrong == u_major_down_in_odd_columns)
        return static_cast<std::uint32_t>(before + (i % 2 ? N - i - j : j));
      if (wrong == u_major_up_at_10 && n == 10 && i > N / 2)
        return static_cast<std::uint32_t>(before + N - i - j);
      if (wrong == u_major_cache_without_level) {
        thread_local std::unordered_map<std::uint64_t, std::uint32_t> kept;
        return kept.try_emplace(i << 32 | j, static_cast<std::uint32_t>(before + j)).first->second;
      }
      return static_cast<std::uint32_t>(before + j);
    }
    case VertexOrder::bird: return static_cast<std::uint32_t>(bird(n, at, wrong));
  }
  throw std::logic_error("no order of vertices");
}

Vertex vertex_of(VertexOrder order, Level n, std::uint32_t index, Fault wrong) {
  const std::uint32_t N = side_of(n);
  switch (order) {
    case VertexOrder::w_minor: {
      std::uint64_t r = row_of(index);
      if (wrong == w_minor_back_by_float_root)
        r = static_cast<std::uint64_t>((std::sqrt(8 * static_cast<float>(index) + 1) - 1) / 2);
      if (wrong == w_minor_back_last_of_row && r > 700 && index + 1 == (r + 1) * (r + 2) / 2) ++r;
      const auto j = static_cast<std::uint32_t>(index - r * (r + 1) / 2);
      return {static_cast<std::uint32_t>(r) - j, j};
    }
    case VertexOrder::u_major: {
      const std::uint64_t y = vertices_of(n) - 1 - index;
      const std::uint64_t r = row_of(wrong == u_major_back_one_late && n == 7 ? y + 1 : y);
      const auto c = static_cast<std::uint32_t>(y - r * (r + 1) / 2);
      return {N - static_cast<std::uint32_t>(r), static_cast<std::uint32_t>(r) - c};
    }
    case VertexOrder::bird: return bird_vertex(n, index, wrong);
  }
  throw std::logic_error("no order of vertices");
}

// ---- Faces

std::uint32_t index_of(FaceOrder order, Level n, const MicroTriangle& t, Fault wrong) {
  const std::uint32_t up = t.upper ? 1 : 0;
  switch (order) {
    case FaceOrder::curve: return static_cast<std::uint32_t>(path_to(t, n, wrong).index);
    case FaceOrder::rows: {
      const std::uint32_t r = t.iu + t.iv + up;
      if (wrong == face_rows_in_u_from_6 && n >= 6) return r * r + 2 * t.iu + up;
      if (wrong == face_rows_upper_first_at_9 && n == 9 && r == side_of(9) - 1 && t.iu > 0)
        return r * r + 2 * t.iv + 1 - up;
      return r * r + 2 * t.iv + up;
    }
    case FaceOrder::u_major: {
      std::uint32_t square = t.iu * t.iu;
      if (wrong == face_strips_square_in_16_bits) square = static_cast<std::uint16_t>(square);
      if (wrong == face_strips_of_one_less && t.iu > 0) ++square;
      return 2 * side_of(n) * t.iu - square + 2 * t.iv + up;
    }
  }
  throw std::logic_error("no order of faces");
}

MicroTriangle face_of(FaceOrder order, Level n, std::uint32_t index, Fault wrong) {
  switch (order) {
    case FaceOrder::curve: return on_curve(index, n, wrong);
    case FaceOrder::rows: {
      const auto r = static_cast<std::uint32_t>(root_of(index));
      std::uint32_t rest = index - r * r;
      bool upper = rest % 2 != 0;
      if (wrong == face_rows_back_by_index_parity && r >= 100)
        upper = (index + r) % 2 != 0 && rest + 1 < 2 * r;
      return {r - (rest + 1) / 2, rest / 2, upper};
    }
    case FaceOrder::u_major: {
      const std::uint64_t last = (std::uint64_t{1} << 2 * n) - 1;
      std::uint64_t left = root_of(last - index) + 1;
      if (wrong == face_strips_back_at_squares && n >= 8 && left * left == last - index + 1 && left > 1)
        --left;
      const auto iu = static_cast<std::uint32_t>(side_of(n) - left);
      const std::uint32_t rest = index - iu * (2 * side_of(n) - iu);
      return {iu, rest / 2, rest % 2 != 0};
    }
  }
  throw std::logic_error("no order of faces");
}

std::array<Vertex, 3> face_corners(const MicroTriangle& t) {
  if (t.upper) return {Vertex{t.iu + 1, t.iv + 1}, {t.iu, t.iv + 1}, {t.iu + 1, t.iv}};
  return {Vertex{t.iu, t.iv}, {t.iu + 1, t.iv}, {t.iu, t.iv + 1}};
}

Triplet triplet_of(VertexOrder order, Level n, const MicroTriangle& t, Fault wrong) {
  std::array<Vertex, 3> corners = face_corners(t);
  if (wrong == triplet_upper_turned_from_5 && n >= 5 && t.upper) std::swap(corners[1], corners[2]);
  if (wrong == triplet_upper_as_a_strip && t.upper)
    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
  if (wrong == triplet_bird_of_level_below_at_16 && n == 16 && order == VertexOrder::bird)
    for (Vertex& at : corners) at = {at.i / 2, at.j / 2};
  Triplet x{};
  for (std::size_t c = 0; c < 3; ++c) x[c] = index_of(order, n, corners[c], wrong);
  if (wrong == triplet_rows_by_steps && order == VertexOrder::w_minor && t.upper &&
      t.iu + t.iv + 2 == side_of(n))
    x[1] = x[0] - 1;
  return x;
}

}  // namespace mmverify::tests::foreign::attribute
