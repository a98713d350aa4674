#include <memory>
#include <stdexcept>

#include "cli/bench/codec/codec.hpp"
#include "impl/attribute/order.hpp"

namespace mmverify::cli::codec::of_attribute {
namespace {

using impl::attribute::VertexOrder;

constexpr std::size_t count = 1 << 16;

/// Vertices of a level, their indices by both, and their places.
struct Row {
  std::vector<std::uint32_t> i, j, theirs, ours, place;
};

std::shared_ptr<Row> row_of(std::uint32_t level, std::uint64_t seed) {
  const std::uint32_t side = std::uint32_t{1} << level;
  auto row =
      std::make_shared<Row>(Row{random_below(side + 1, count, seed), random_below(side + 1, count, seed + 1),
                                std::vector<std::uint32_t>(count), std::vector<std::uint32_t>(count),
                                std::vector<std::uint32_t>(2 * count)});
  for (std::size_t k = 0; k < count; ++k)
    if (row->i[k] + row->j[k] > side) row->i[k] = side - row->i[k], row->j[k] = side - row->j[k];
  return row;
}

}  // namespace

void cases(const Asked& asked) {
  const mmverify_subject_t& s = asked.subject;
  if (s.attribute_vertex_index == nullptr)
    throw std::runtime_error(asked.options.subject + ": no attribute_vertex_index");
  constexpr std::pair<VertexOrder, const char*> orders[] = {{VertexOrder::w_minor, "vertices, w-minor"},
                                                            {VertexOrder::u_major, "vertices, u-major"},
                                                            {VertexOrder::bird, "vertices, bird"}};
  for (std::uint32_t order = 0; order < 3; ++order)
    for (std::uint32_t n = asked.levels.first; n <= asked.levels.last; ++n) {
      const auto row = row_of(n, asked.options.index.seed);
      bench::CodecCase c{.of = orders[order].second, .level = n, .lookups = count};
      c.theirs.look_up = [&s, row, n, order] {
        s.attribute_vertex_index(n, order, row->i.data(), row->j.data(), row->theirs.data(), count);
      };
      c.ours.look_up = [row, n, order = orders[order].first] {
        impl::attribute::vertex_index(order, row->i, row->j, n, row->ours);
      };
      c.theirs.changed = [row] {
        std::uint64_t changed = 0;
        for (std::size_t k = 0; k < count; ++k) changed += row->theirs[k] != row->ours[k] ? 1 : 0;
        return changed;
      };
      asked.take(c);
    }
}

}  // namespace mmverify::cli::codec::of_attribute
