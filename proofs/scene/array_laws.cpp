// The scene's array, and its way from a triangle to its states.
#include "impl/micromap_validate.hpp"
#include "proofs/scene/law_groups.hpp"
#include "proofs/scene/law_parts.hpp"
#include "proofs/scene/other_order.hpp"

namespace mmverify::proofs::scene {
namespace {

namespace micromap = impl::micromap;
using impl::scene::BakedTriangle;
using impl::scene::TriangleUse;

/// Everything that `validate` is given of one primitive.
micromap::Input input_of(const Data& data, std::size_t primitive, const micromap::Bytes& records) {
  const impl::scene::PrimitiveIndices& indices = data.arrays.primitives[primitive];
  micromap::Input in;
  // u8 indices and what else EXT forbids do not occur; all sets of rules are to hold.
  in.records = records;
  in.record_count = data.arrays.array.records.size();
  in.data = data.arrays.array.data;
  in.triangles = data.plan.primitives[primitive].triangles.size();
  in.indexed = true;
  in.indices = indices.geometry.indices;
  in.encoding = data.arrays.encoding;
  in.index_stride = micromap::width(in.encoding) / 8;
  in.geometry_counts = indices.geometry.counts;
  return in;
}

Law valid_law(const Data& data) {
  return over(
      {.id = "micromap.valid",
       .topic = "micromap",
       .says = "the array and each primitive's indices and counts break no rule of EXT, KHR, DXR and glTF",
       .source = "VK_EXT_opacity_micromap, VK_KHR_opacity_micromap, DXR 1.2, EXT_mesh_opacity_micromap; "
                 "spec/micromap_rules.hpp"},
      {"primitives with micromaps", [&data](Level n) { return n == 0 ? data.plan.primitives.size() : 0; },
       [&data](Level, std::uint64_t k) -> Finding {
         const micromap::Bytes records = micromap::record_buffer(data.arrays.array.records);
         const std::vector<micromap::UsageCount> counts = micromap::usage_counts(data.arrays.array.records);
         micromap::Input in = input_of(data, k, records);
         in.array_counts = counts;
         const auto violations = micromap::validate(in);
         if (violations.empty()) return {in.triangles};
         return wrong("no violation", micromap::describe(violations.front()));
       }});
}

/// The uses of planned triangles that have this level, each distinct triangle and order of vertices once.
struct Uses {
  struct One {
    std::size_t primitive, triangle;
  };
  std::vector<std::vector<One>> of = std::vector<std::vector<One>>(17);

  explicit Uses(const Data& data) {
    std::vector<std::array<bool, 64>> seen(data.baked.triangles.size());
    for (std::size_t p = 0; p < data.plan.primitives.size(); ++p) {
      const auto& triangles = data.plan.primitives[p].triangles;
      for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& o = triangles[t].order;
        bool& known = seen[triangles[t].triangle][static_cast<std::size_t>(o[0] * 16 + o[1] * 4 + o[2])];
        if (!known) of[data.baked.triangles[triangles[t].triangle].level].push_back({p, t});
        known = true;
      }
    }
  }
};

/// The state that a device finds at micro-triangle `index` of a primitive's triangle: by its code, its record
/// and its data.
unsigned by_indirection(const Data& data, std::size_t primitive, std::size_t triangle, std::uint32_t index) {
  const auto& bytes = data.arrays.primitives[primitive].geometry.indices;
  const std::size_t width = micromap::width(data.arrays.encoding) / 8;
  std::uint32_t code = 0;
  for (std::size_t k = 0; k < width; ++k) code |= std::uint32_t{bytes[triangle * width + k]} << (8 * k);
  if (const auto state = micromap::special_state(code, data.arrays.encoding))
    return static_cast<unsigned>(*state);
  const micromap::Record& record = data.arrays.array.records[code];
  const unsigned b = record.format;
  const std::size_t bit = std::size_t{index} * b;
  return data.arrays.array.data[record.offset + bit / 8] >> (bit % 8) & ((1u << b) - 1);
}

Law indirection_law(const Data& data) {
  const auto uses = std::make_shared<const Uses>(data);
  return over(
      {.id = "micromap.indirection",
       .topic = "micromap",
       .says =
           "a triangle's code, record and data give the states that were baked for it, in its own order of "
           "vertices",
       .source = "VkAccelerationStructureTrianglesOpacityMicromapKHR; VkMicromapTriangleKHR"},
      {"triangles with a map and order of their own", [uses](Level n) { return uses->of[n].size(); },
       [&data, uses](Level n, std::uint64_t k) -> Finding {
         const auto [primitive, triangle] = uses->of[n][k];
         const TriangleUse& use = data.plan.primitives[primitive].triangles[triangle];
         const BakedTriangle& baked = data.baked.triangles[use.triangle];
         // All of a small map; of a large one steps that meet every digit.
         const std::uint64_t count = micromap::micro_triangles(n);
         const std::uint64_t step = n <= 6 ? 1 : (count >> 12) + 1;
         Finding found;
         for (std::uint64_t at = 0; at < count; at += step) {
           const auto index = static_cast<std::uint32_t>(at);
           const unsigned got = by_indirection(data, primitive, triangle, index);
           unsigned expected = 0;
           if (baked.uniform) {
             expected = static_cast<unsigned>(*baked.uniform);
           } else {
             const std::size_t b = micromap::bits(baked.format);
             const std::size_t bit = in_planned_order(index, n, use.order) * b;
             expected = baked.map[bit / 8] >> (bit % 8) & ((1u << b) - 1);
           }
           found.answer = found.answer * 31 + got;
           if (got != expected)
             return wrong(
                 fmt::format("state {} of micro-triangle {} of triangle {}", expected, index, triangle),
                 fmt::format("{}", got));
         }
         return found;
       }});
}

}  // namespace

std::vector<Law> array_laws(const Data& data) { return {valid_law(data), indirection_law(data)}; }

}  // namespace mmverify::proofs::scene
