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

/// The uses of planned triangles that have this level, by distinct triangle and order of vertices.
struct Uses {
  struct One {
    std::size_t primitive, triangle;
  };
  std::vector<std::vector<std::vector<One>>> of = std::vector<std::vector<std::vector<One>>>(17);

  explicit Uses(const Data& data) {
    std::vector<std::array<std::size_t, 64>> known(data.baked.triangles.size());  // places in `of`, plus 1
    for (std::size_t p = 0; p < data.plan.primitives.size(); ++p) {
      const auto& triangles = data.plan.primitives[p].triangles;
      for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& o = triangles[t].order;
        auto& level = of[data.baked.triangles[triangles[t].triangle].level];
        std::size_t& place =
            known[triangles[t].triangle][static_cast<std::size_t>(o[0] * 16 + o[1] * 4 + o[2])];
        if (place == 0) {
          level.emplace_back();
          place = level.size();
        }
        level[place - 1].push_back({p, t});
      }
    }
  }
};

std::uint32_t code_of(const Data& data, const Uses::One& use) {
  const auto& bytes = data.arrays.primitives[use.primitive].geometry.indices;
  const std::size_t width = micromap::width(data.arrays.encoding) / 8;
  std::uint32_t code = 0;
  for (std::size_t k = 0; k < width; ++k) code |= std::uint32_t{bytes[use.triangle * width + k]} << (8 * k);
  return code;
}

/// The state that a device finds at micro-triangle `index` of a triangle with that code: by its record and its data.
unsigned by_indirection(const Data& data, std::uint32_t code, std::uint32_t index) {
  if (const auto state = micromap::special_state(code, data.arrays.encoding))
    return static_cast<unsigned>(*state);
  const micromap::Record& record = data.arrays.array.records[code];
  const unsigned b = record.format;
  const std::size_t bit = std::size_t{index} * b;
  return data.arrays.array.data[record.offset + bit / 8] >> (bit % 8) & ((1u << b) - 1);
}

/// Maps up to this level are seen whole; of larger ones some 65,536 places, and then nothing is proved.
constexpr Level whole_maps = 9;

Law indirection_law(const Data& data) {
  const auto uses = std::make_shared<const Uses>(data);
  Law law = over(
      {.id = "micromap.indirection",
       .topic = "micromap",
       .says =
           "a triangle's code, record and data give the states that were baked for it, in its own order of "
           "vertices",
       .source = "VkAccelerationStructureTrianglesOpacityMicromapKHR; VkMicromapTriangleKHR"},
      {"triangles with a map and order of their own", [uses](Level n) { return uses->of[n].size(); },
       [&data, uses](Level n, std::uint64_t k) -> Finding {
         const auto [primitive, triangle] = uses->of[n][k].front();
         const std::uint32_t code = code_of(data, {primitive, triangle});
         // The others have its map and its order, and so its code.
         for (const Uses::One& other : uses->of[n][k])
           if (const std::uint32_t got = code_of(data, other); got != code)
             return wrong(
                 fmt::format("code {} of triangle {} of primitive {}, as triangle {} of primitive {} has it",
                             code, other.triangle, other.primitive, triangle, primitive),
                 fmt::format("{}", got));
         const TriangleUse& use = data.plan.primitives[primitive].triangles[triangle];
         const BakedTriangle& baked = data.baked.triangles[use.triangle];
         // Of a large map steps that meet every digit.
         const std::uint64_t count = micromap::micro_triangles(n);
         const std::uint64_t step = n <= whole_maps ? 1 : (count >> 16) + 1;
         Finding found;
         for (std::uint64_t at = 0; at < count; at += step) {
           const auto index = static_cast<std::uint32_t>(at);
           const unsigned got = by_indirection(data, code, index);
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
  for (Level n = whole_maps + 1; n < uses->of.size(); ++n)
    if (!uses->of[n].empty()) law.method = Method::sample;
  law.how = [](const Subject&, Level n) { return std::string(n <= whole_maps ? "exhaustive" : "sample"); };
  law.domain = [whole = law.domain](const Subject& s, Level n) {
    return whole(s, n) + (n <= whole_maps ? "" : "; some 65,536 places of each");
  };
  return law;
}

}  // namespace

std::vector<Law> array_laws(const Data& data) { return {valid_law(data), indirection_law(data)}; }

}  // namespace mmverify::proofs::scene
