// What the laws of baking share: entry points, a map held against the true one, and mutants.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "proofs/attribute/bake/cases.hpp"
#include "proofs/attribute/law_parts.hpp"

namespace mmverify::proofs::attribute {

inline constexpr char cam_5[] = "Color and Attribute Micromaps, 5.1";

inline constexpr Entry bakes_vertices{"vertices", [](const Functions& f) { return bool(f.baking.vertices); }};
inline constexpr Entry bakes_faces{"faces", [](const Functions& f) { return bool(f.baking.faces); }};

/// "micro-vertex i=1,j=2" of W-minor order, or "face 3" of the curve.
std::string name_of(MapForm form, std::uint32_t k);

/// How far from the true codes a subject's may be: none of the channels further than its tolerance.
enum class Match : std::uint8_t { same, within, wrong };
Match match(const Rgba& expected, const Rgba& got, std::uint32_t tolerance);

/// A subject's map beside the true one; an empty one is declined.
Finding compared(MapForm form, const std::vector<Rgba>& expected, const std::vector<Rgba>& got,
                 std::uint32_t tolerance);

/// The law with cases inside what its subjects support, which its domain says; up to their highest level.
Law within_support(Law law);

using MapBaker = std::function<std::vector<Rgba>(const BakeCase&, Level)>;
inline MapBaker& map_baker(Baking& f, MapForm form) { return form == MapForm::faces ? f.faces : f.vertices; }
inline const MapBaker& map_baker(const Baking& f, MapForm form) {
  return form == MapForm::faces ? f.faces : f.vertices;
}

/// Of a mutant: bakes another case, where `meant`.
std::function<void(Functions&)> bakes_another(MapForm form, std::function<void(BakeCase&)> change);
/// Rounds what lies in the middle between two codes down.
std::function<void(Functions&)> rounds_half_down(MapForm form);
/// Averages the texels whose centres lie in the micro-triangle, or takes the one under its centroid.
std::function<void(Functions&)> averages_centres();
/// Takes positions in binary32, as p0 + (p1 - p0) u + (p2 - p0) v.
std::function<void(Functions&)> places_in_floats();
/// Gives every part of a segment the same weight, where the triangle is one.
std::function<void(Functions&)> spreads_evenly();
/// Takes the mean of the sampler's values at the three corners.
std::function<void(Functions&)> averages_corners();

std::vector<Law> bake_map_laws();
std::vector<Law> bake_relation_laws();
std::vector<Law> bake_error_laws();
std::vector<Law> plan_laws();

}  // namespace mmverify::proofs::attribute
