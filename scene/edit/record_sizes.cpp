#include "scene/edit/record_sizes.hpp"

#include <algorithm>

#include "impl/micromap/micromap.hpp"

namespace mmverify::scene {
namespace {

namespace micromap = impl::micromap;

constexpr std::uint16_t finest = 12;

struct Shape {
  std::uint16_t level = 0, format = 0;
};

std::uint64_t bytes_of(const Shape& shape) {
  return micromap::packed_bytes(micromap::micro_triangles(shape.level),
                                static_cast<micromap::Format>(shape.format));
}

bool is_shape(const micromap::Record& r) { return r.level <= finest && (r.format == 1 || r.format == 2); }

/// The level and format of that size; nothing if there are none or several.
std::optional<Shape> shape_of(std::uint64_t bytes) {
  std::optional<Shape> found;
  for (std::uint16_t format = 1; format <= 2; ++format)
    for (std::uint16_t level = 0; level <= finest; ++level)
      if (bytes_of({level, format}) == bytes) {
        if (found) return {};
        found = Shape{level, format};
      }
  return found;
}

}  // namespace

std::optional<std::vector<micromap::Record>> sized_by_gaps(std::vector<micromap::Record> records,
                                                           std::uint64_t data_bytes) {
  std::vector<micromap::Record*> in_order;
  for (micromap::Record& r : records) in_order.push_back(&r);
  std::sort(in_order.begin(), in_order.end(), [](auto* a, auto* b) { return a->offset < b->offset; });
  if (in_order.empty() || in_order.front()->offset != 0) return {};
  for (std::size_t k = 0; k < in_order.size(); ++k) {
    micromap::Record& r = *in_order[k];
    const std::uint64_t end = k + 1 < in_order.size() ? in_order[k + 1]->offset : data_bytes;
    if (end <= r.offset) return {};
    if (is_shape(r) && bytes_of({r.level, r.format}) == end - r.offset) continue;
    const std::optional<Shape> shape = shape_of(end - r.offset);
    if (!shape) return {};
    r.level = shape->level, r.format = shape->format;
  }
  return records;
}

}  // namespace mmverify::scene
