// The functions of a subject of topic attribute for mip chains and levels of detail.
#pragma once

#include "proofs/engine/law.hpp"
#include "spec/attribute/mip.hpp"

namespace mmverify::proofs::attribute {

using spec::attribute::Rounding;
using spec::attribute::VertexOrder;

/// The source of a chain's level: the codes of the level above, or the sums of the base's codes.
enum class ChainOf : std::uint32_t { level_above, exact_sums };

/// A blend of two levels: `level` with the weight 1 - blend, level + 1 with blend.
struct LevelOfDetail {
  Level level;
  double blend;
};

/// RGBA8 values are words of four codes, one a byte; face maps lie in the order of the curve.
struct Mips {
  /// The map one level below: each parent has four children.
  std::function<void(Rounding, std::span<const std::uint32_t> children, std::span<std::uint32_t> parents)>
      face_mip = {};
  /// All levels below a base of level n, the coarsest first.  Domain: n in 0..12; exact sums have no halves_up.
  std::function<void(Level n, Rounding, ChainOf, std::span<const std::uint32_t> base,
                     std::span<std::uint32_t> chain)>
      face_chain = {};
  /// The number of values below level m in a chain of faces, and of vertices.
  std::function<std::uint64_t(Level m)> face_chain_size = {}, vertex_chain_size = {};
  /// The index in the map of level n that has the value of vertex k of level m.
  std::function<std::uint32_t(VertexOrder, std::uint32_t k, Level m, Level n)> vertex_mip_source = {};
  /// The level for a cone's area and a triangle's area, for each pair.  Domain: n in 0..16.
  std::function<void(Level n, std::span<const float> cone, std::span<const float> triangle, std::span<Level>)>
      lod_level = {};
  std::function<LevelOfDetail(Level n, float cone, float triangle)> lod = {};
};

}  // namespace mmverify::proofs::attribute
