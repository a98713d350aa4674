#include "proofs/planning/fast_levels.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace mmverify::proofs {
namespace {

/// Orders of attribute micromaps.  The library takes elements in batches, some ns each, and goes on to level 12; the
/// specification's walks do not, and are proved at every level by induction (proofs/attribute/induction).
constexpr std::array<std::string_view, 9> of_orders{
    "attribute.order_bijective",     "attribute.order_inverse",     "attribute.order_is_walk",
    "attribute.face_orders",         "attribute.convert",           "attribute.convert_faces",
    "attribute.order_prefix_nested", "attribute.triangle_vertices", "attribute.umajor_is_reversed_rows"};

}  // namespace

std::vector<std::pair<std::string, Levels>> fast_levels_apart(const Law& law) {
  // It asks for each vertex on 16 levels, not on one or two.
  if (law.id == "attribute.bird_prefix") return {{"attribute", {0, 10}}};
  if (std::find(of_orders.begin(), of_orders.end(), law.id) == of_orders.end()) return {};
  return {{"attribute", {0, 12}}};
}

Levels fast_levels(const Law& law, const Subject& subject) {
  for (const auto& [name, levels] : fast_levels_apart(law))
    if (name == subject.name()) return levels;
  return law.tiers.fast;
}

}  // namespace mmverify::proofs
