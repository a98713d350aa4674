#include "scene/bake/arrays.hpp"

#include <algorithm>
#include <cstring>
#include <optional>

#include "impl/micromap/histogram.hpp"
#include "impl/micromap/reorder.hpp"

namespace mmverify::scene {
namespace {

using namespace impl::micromap;

/// The six orders in lexical order; rank() is the number of an order.
constexpr std::array<VertexOrder, 6> orders{
    {{{0, 1, 2}}, {{0, 2, 1}}, {{1, 0, 2}}, {{1, 2, 0}}, {{2, 0, 1}}, {{2, 1, 0}}}};
std::size_t rank(const VertexOrder& order) {
  return static_cast<std::size_t>(std::find(orders.begin(), orders.end(), order) - orders.begin());
}

/// A code for each distinct map and order in use, and the array that the codes refer to.
class Codes {
 public:
  Codes(const Plan& plan, const Baked& baked) : baked_(baked), codes_(baked.triangles.size()) {
    std::vector<Bytes> reordered;
    std::vector<PackedMap> maps;
    std::vector<std::uint32_t*> wanted;
    for (const PlannedPrimitive& primitive : plan.primitives)
      for (const TriangleUse& use : primitive.triangles) {
        const BakedTriangle& triangle = baked.triangles[use.triangle];
        std::optional<std::uint32_t>& code = codes_[use.triangle][rank(use.order)];
        if (triangle.uniform || code) continue;
        code = 0;
        wanted.push_back(&*code);
        PackedMap map{triangle.level, triangle.format, triangle.map};
        if (use.order != orders[0]) {
          // Moving a vector leaves its bytes where they are.
          map.bytes = reordered.emplace_back(triangle.map.size());
          reorder(triangle.map, triangle.level, triangle.format, use.order, reordered.back());
        }
        maps.push_back(map);
      }
    reordered_ = reordered.size();
    // No map here is uniform, so each code is a record's number.
    const Geometry geometry = append(array_, maps, {Encoding::u32, 0, true, true});
    for (std::size_t k = 0; k < wanted.size(); ++k)
      std::memcpy(wanted[k], geometry.indices.data() + 4 * k, sizeof(std::uint32_t));
  }

  std::uint32_t code(const TriangleUse& use, Encoding encoding) const {
    const auto& uniform = baked_.triangles[use.triangle].uniform;
    return uniform ? special_code(*uniform, encoding) : *codes_[use.triangle][rank(use.order)];
  }
  bool special(const TriangleUse& use) const { return baked_.triangles[use.triangle].uniform.has_value(); }
  std::uint64_t reordered() const { return reordered_; }
  Array take() { return std::move(array_); }

 private:
  const Baked& baked_;
  std::vector<std::array<std::optional<std::uint32_t>, 6>> codes_;
  std::uint64_t reordered_ = 0;
  Array array_;
};

}  // namespace

SceneArrays arrays(const Plan& plan, const Baked& baked) {
  Codes codes(plan, baked);
  SceneArrays all;
  all.array = codes.take();
  all.reordered = codes.reordered();
  all.encoding = all.array.records.size() <= index_limit(Encoding::u16) ? Encoding::u16 : Encoding::u32;
  const std::size_t bytes = width(all.encoding) / 8;
  for (const PlannedPrimitive& primitive : plan.primitives) {
    PrimitiveIndices indices{primitive.primitive, {}};
    indices.geometry.indices.resize(primitive.triangles.size() * bytes);
    detail::Histogram histogram;
    std::uint8_t* to = indices.geometry.indices.data();
    for (const TriangleUse& use : primitive.triangles) {
      const std::uint32_t code = codes.code(use, all.encoding);
      std::memcpy(to, &code, bytes);
      to += bytes;
      if (codes.special(use)) {
        ++all.special;
      } else {
        const Record& record = all.array.records[code];
        histogram.add(record.level, record.format, 1);
      }
    }
    indices.geometry.counts = histogram.counts();
    all.primitives.push_back(std::move(indices));
  }
  return all;
}

}  // namespace mmverify::scene
