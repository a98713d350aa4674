#include "proofs/attribute/orders/walks.hpp"

#include "proofs/engine/random.hpp"
#include "spec/attribute/order.hpp"

namespace mmverify::proofs::attribute {

VertexWalks::VertexWalks(Level n) {
  const std::uint32_t N = spec::side(n);
  std::uint32_t rows = 0, columns = 0;
  for (std::uint32_t k = 0; k <= N; ++k) {
    rows_.push_back(rows);
    columns_.push_back(columns);
    rows += k + 1;
    columns += N + 1 - k;
  }
  bird_.assign(columns, 0);
  std::uint32_t next = 0;
  const auto visit = [&](const Vertex& at) { bird_[columns_[at.i] + at.j] = next++; };
  visit({0, 0});
  visit({N, 0});
  visit({0, N});
  for (Level m = 1; m <= n; ++m) {
    const Level coarse = m - 1, up = n - coarse;
    for (std::uint64_t x = 0; x < spec::attribute::face_count(coarse); ++x) {
      // Corners come in the order of the children 0, 2 and 3; upright ones have a base below a third corner.
      const spec::index::Corners c = spec::index::corners(static_cast<std::uint32_t>(x), coarse);
      const auto has = [&](const Vertex& v) { return c[0] == v || c[1] == v || c[2] == v; };
      const std::uint32_t i = std::min({c[0].i, c[1].i, c[2].i}), j = std::min({c[0].j, c[1].j, c[2].j});
      if (!has({i, j})) continue;
      const std::uint32_t half = std::uint32_t{1} << up >> 1, wi = i << up, wj = j << up;
      visit({wi, wj + half});
      visit({wi + half, wj + half});
      visit({wi + half, wj});
    }
  }
}

std::uint32_t VertexWalks::index(VertexOrder order, const Vertex& at) const {
  switch (order) {
    case VertexOrder::w_minor: return rows_[at.i + at.j] + at.j;
    case VertexOrder::u_major: return columns_[at.i] + at.j;
    case VertexOrder::bird: break;
  }
  return bird_[columns_[at.i] + at.j];
}

const VertexWalks& vertex_walks(Level n) {
  struct Made {
    std::once_flag once;
    std::optional<VertexWalks> walks;
  };
  static std::array<Made, 14> made;
  Made& level = made.at(n);
  std::call_once(level.once, [&] { level.walks.emplace(n); });
  return *level.walks;
}

namespace {

using spec::attribute::vertex_count;
using spec::attribute::vertex_orders;

/// A number in [0, last]: near an end, near a power of two, or any.
std::uint32_t number(Random& random, std::uint32_t last) {
  const auto any = [&] { return static_cast<std::uint32_t>(random.below(std::uint64_t{last} + 1)); };
  switch (random.below(4)) {
    case 0: return std::min<std::uint32_t>(last, static_cast<std::uint32_t>(random.below(3)));
    case 1: return last - std::min<std::uint32_t>(last, static_cast<std::uint32_t>(random.below(3)));
    case 2: {
      const std::int64_t power = std::int64_t{1} << random.below(17);
      return static_cast<std::uint32_t>(std::clamp<std::int64_t>(power + random.between(-1, 1), 0, last));
    }
    default: return any();
  }
}

/// The vertex `a` steps along one side from a corner and `b` along the other.
Vertex from_corner(std::uint64_t corner, std::uint32_t N, std::uint32_t a, std::uint32_t b) {
  return corner == 0 ? Vertex{a, b} : corner == 1 ? Vertex{N - a - b, a} : Vertex{b, N - a - b};
}

Vertex of_index(Random& random, Level n, std::uint64_t about) {
  const auto last = static_cast<std::int64_t>(vertex_count(n) - 1);
  const std::int64_t index =
      std::clamp<std::int64_t>(static_cast<std::int64_t>(about) + random.between(-2, 2), 0, last);
  return spec::attribute::vertex_at(vertex_orders[random.below(3)], static_cast<std::uint64_t>(index), n);
}

}  // namespace

Vertex drawn_vertex(Level n, std::uint64_t k, std::uint64_t seed) {
  Random random(seed, n, k);
  const std::uint32_t N = spec::side(n);
  switch (k % 8) {
    case 0: {
      const auto a = static_cast<std::uint32_t>(random.below(std::uint64_t{N} + 1)),
                 b = static_cast<std::uint32_t>(random.below(std::uint64_t{N} + 1));
      return a + b <= N ? Vertex{a, b} : Vertex{N - a, N - b};
    }
    case 1: {
      const auto a = static_cast<std::uint32_t>(random.below(std::min<std::uint32_t>(N / 2, 8) + 1)),
                 b = static_cast<std::uint32_t>(random.below(std::min<std::uint32_t>(N / 2, 8) + 1));
      return from_corner(random.below(3), N, a, b);
    }
    case 2: {
      const auto off = static_cast<std::uint32_t>(random.below(std::min<std::uint32_t>(N, 3) + 1));
      const std::uint32_t along = number(random, N - off);
      return from_corner(random.below(3), N, off, along);
    }
    case 3: {
      // A vertex near an end of row r = i + j, or of column i.
      const std::uint32_t r = number(random, N), at = number(random, 3) % (r + 1),
                          j = random.below(2) == 0 ? at : r - at;
      if (random.below(2) == 0) return {r - j, j};
      return {r, std::min(N - r, at)};
    }
    case 4: {
      const std::uint32_t a = number(random, N);
      const std::uint32_t b = number(random, N - a);
      return from_corner(random.below(3), N, a, b);
    }
    case 5:
    case 6: return of_index(random, n, std::uint64_t{1} << random.below(32));
    default: return of_index(random, n, random.below(vertex_count(n)) >> 16 << 16);
  }
}

MicroTriangle drawn_face(Level n, std::uint64_t k, std::uint64_t seed) {
  const std::uint32_t N = spec::side(n);
  Vertex base = drawn_vertex(n, k, seed);
  if (base.i + base.j == N) --(base.i == 0 ? base.j : base.i);
  Random random(seed, 100 + std::uint64_t{n}, k);
  return {base.i, base.j, base.i + base.j + 1 < N && random.below(2) == 1};
}

}  // namespace mmverify::proofs::attribute
