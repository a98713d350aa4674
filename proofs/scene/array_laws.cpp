// Laws of the scene's array, and of the way from a triangle to its states.
#include "impl/micromap/validate.hpp"
#include "proofs/scene/law_parts.hpp"
#include "proofs/scene/laws.hpp"
#include "proofs/scene/other_order.hpp"

namespace mmverify::proofs::scene {
namespace {

namespace micromap = impl::micromap;
using mmverify::scene::BakedTriangle;
using mmverify::scene::TriangleUse;

/// The input of `validate` for one primitive.
micromap::Input input_of(const Data& data, std::size_t primitive, const micromap::Bytes& records) {
  const mmverify::scene::PrimitiveIndices& indices = data.arrays.primitives[primitive];
  micromap::Input in;
  // The rules of all APIs must hold: a scene's array has no u8 indices, and nothing else that EXT forbids.
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
  return on_cases(
      {.id = "micromap.valid",
       .topic = "micromap",
       .says = "the array and each primitive's indices and counts break no rule of EXT, KHR, DXR and glTF",
       .source = "VK_EXT_opacity_micromap, VK_KHR_opacity_micromap, DXR 1.2, EXT_mesh_opacity_micromap; "
                 "spec/micromap/rules.hpp"},
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

/// A triangle of a primitive that has a micromap.
struct Use {
  std::size_t primitive, triangle;
};

/// The triangles of all primitives, by the level of their maps.
struct Uses {
  struct One {
    Use use;
    Use first;  ///< the first use with the same planned triangle and order of vertices; may be `use` itself
  };
  std::vector<std::vector<One>> of = std::vector<std::vector<One>>(17);

  explicit Uses(const Data& data) {
    std::vector<std::array<std::optional<Use>, 64>> seen(data.baked.triangles.size());
    for (std::size_t p = 0; p < data.plan.primitives.size(); ++p) {
      const auto& triangles = data.plan.primitives[p].triangles;
      for (std::size_t t = 0; t < triangles.size(); ++t) {
        const auto& o = triangles[t].order;
        std::optional<Use>& first =
            seen[triangles[t].triangle][static_cast<std::size_t>(o[0] * 16 + o[1] * 4 + o[2])];
        if (!first) first = Use{p, t};
        of[data.baked.triangles[triangles[t].triangle].level].push_back({{p, t}, *first});
      }
    }
  }
};

std::uint32_t code_of(const Data& data, const Use& use) {
  const auto& bytes = data.arrays.primitives[use.primitive].geometry.indices;
  const std::size_t width = micromap::width(data.arrays.encoding) / 8;
  std::uint32_t code = 0;
  for (std::size_t k = 0; k < width; ++k) code |= std::uint32_t{bytes[use.triangle * width + k]} << (8 * k);
  return code;
}

/// One of the packed states of `b` bits.
unsigned state_at(std::span<const std::uint8_t> map, std::uint64_t index, unsigned b) {
  return map[index * b / 8] >> (index * b % 8) & ((1u << b) - 1);
}

/// The states that a device finds by a code: one state of a whole triangle, or a record's map.
struct DeviceMap {
  std::optional<unsigned> special;
  std::span<const std::uint8_t> map;
  unsigned bits = 0;

  unsigned at(std::uint64_t index) const { return special ? *special : state_at(map, index, bits); }
};

/// Nothing if the code names no record, or a record without a map of the level within the data.
std::optional<DeviceMap> found_by(const Data& data, std::uint32_t code, Level n) {
  if (const auto state = micromap::special_state(code, data.arrays.encoding))
    return DeviceMap{static_cast<unsigned>(*state), {}, 0};
  if (code >= data.arrays.array.records.size()) return std::nullopt;
  const micromap::Record& record = data.arrays.array.records[code];
  if (record.level != n || (record.format != 1 && record.format != 2)) return std::nullopt;
  const auto size =
      micromap::packed_bytes(micromap::micro_triangles(n), static_cast<micromap::Format>(record.format));
  const std::span<const std::uint8_t> all(data.arrays.array.data);
  if (record.offset > all.size() || size > all.size() - record.offset) return std::nullopt;
  return DeviceMap{std::nullopt, all.subspan(record.offset, size), record.format};
}

/// Compares every state of a use with the baked one, and their counts with the plan's.
Finding leads_to_its_states(const Data& data, Level n, const Use& at) {
  const TriangleUse& use = data.plan.primitives[at.primitive].triangles[at.triangle];
  const BakedTriangle& baked = data.baked.triangles[use.triangle];
  const std::uint32_t code = code_of(data, at);
  const auto found = found_by(data, code, n);
  if (!found)
    return wrong(
        fmt::format("a map of level {} for triangle {} of primitive {}", n, at.triangle, at.primitive),
        fmt::format("code {}", code));
  const bool planned_order = use.order == mmverify::scene::VertexOrder{0, 1, 2};
  const unsigned b = micromap::bits(baked.format);
  micromap::StateCounts counts{};
  Finding finding;
  for (std::uint64_t index = 0; index < micromap::micro_triangles(n); ++index) {
    const auto place = static_cast<std::uint32_t>(index);
    const unsigned expected =
        baked.uniform ? static_cast<unsigned>(*baked.uniform)
                      : state_at(baked.map, planned_order ? place : in_planned_order(place, n, use.order), b);
    const unsigned got = found->at(index);
    if (got != expected)
      return wrong(fmt::format("state {} of micro-triangle {} of triangle {} of primitive {}", expected,
                               index, at.triangle, at.primitive),
                   fmt::format("{}", got));
    ++counts[got];
    finding.answer = finding.answer * 31 + got;
  }
  if (counts != baked.states)
    return wrong(fmt::format("{} T, {} O, {} UT, {} UO of planned triangle {}", counts[0], counts[1],
                             counts[2], counts[3], use.triangle),
                 fmt::format("{} T, {} O, {} UT, {} UO", baked.states[0], baked.states[1], baked.states[2],
                             baked.states[3]));
  return finding;
}

Law indirection_law(const Data& data) {
  const auto uses = std::make_shared<const Uses>(data);
  return on_cases({.id = "micromap.indirection",
                   .topic = "micromap",
                   .says = "a triangle's code, record and data give the states that were baked for it, in "
                           "its own order of vertices, and as many of each as were counted",
                   .source = "VkAccelerationStructureTrianglesOpacityMicromapKHR; VkMicromapTriangleKHR"},
                  {"triangles of its primitives", [uses](Level n) { return uses->of[n].size(); },
                   [&data, uses](Level n, std::uint64_t k) -> Finding {
                     const auto& [use, first] = uses->of[n][k];
                     const bool is_first = use.primitive == first.primitive && use.triangle == first.triangle;
                     // A use with the code of its first use has the states that the first use's case checks.
                     if (!is_first && code_of(data, use) == code_of(data, first)) return {code_of(data, use)};
                     return leads_to_its_states(data, n, use);
                   }});
}

}  // namespace

std::vector<Law> array_laws(const Data& data) { return {valid_law(data), indirection_law(data)}; }

}  // namespace mmverify::proofs::scene
