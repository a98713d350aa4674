#include "proofs/attribute/orders/walks.hpp"

#include <map>
#include <mutex>

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
    case VertexOrder::w_minor:
      return rows_[at.i + at.j] + at.j;
    case VertexOrder::u_major:
      return columns_[at.i] + at.j;
    case VertexOrder::bird:
      break;
  }
  return bird_[columns_[at.i] + at.j];
}

std::shared_ptr<const VertexWalks> vertex_walks(Level n) {
  static std::mutex mutex;
  static std::map<Level, std::shared_ptr<const VertexWalks>> made;
  const std::lock_guard lock(mutex);
  auto& found = made[n];
  if (found == nullptr) {
    // One large table at a time.
    if (n > 9)
      std::erase_if(made, [](const auto& other) { return other.first > 9 && other.second != nullptr; });
    made[n] = std::make_shared<const VertexWalks>(n);
  }
  return made[n];
}

}  // namespace mmverify::proofs::attribute
