// Common parts of the laws of baking: entry points, the comparison of a map with the true one, and mutants.
#pragma once

#include "proofs/attribute/bake/cases.hpp"
#include "proofs/attribute/bake/truth.hpp"
#include "proofs/attribute/law_parts.hpp"

namespace mmverify::proofs::attribute {

inline constexpr char cam_5[] = "Color and Attribute Micromaps, 5.1";

inline constexpr Entry bakes_vertices{"vertices", [](const Functions& f) { return bool(f.baking.vertices); }};
inline constexpr Entry bakes_faces{"faces", [](const Functions& f) { return bool(f.baking.faces); }};

/// The name of an element, "micro-vertex i=1,j=2" in W-minor order or "face 3" on the curve.
std::string name_of(MapForm form, std::uint32_t k);

/// The distance of a subject's codes from the true ones: none, within the tolerance in every channel, or more.
enum class Match : std::uint8_t { same, within, wrong };
template <class Channel>
Match match(const RgbaOf<Channel>& expected, const RgbaOf<Channel>& got, std::uint32_t tolerance) {
  std::uint32_t off = 0;
  for (std::size_t c = 0; c < expected.size(); ++c) {
    const std::uint32_t a = bits_of(expected[c]), b = bits_of(got[c]);
    off = std::max(off, a < b ? b - a : a - b);
  }
  return off == 0 ? Match::same : off <= tolerance ? Match::within : Match::wrong;
}

/// A map's value as a number for a digest.
template <class Channel>
std::uint64_t digest_of(const RgbaOf<Channel>& value) {
  if constexpr (sizeof(Channel) == 1) return std::bit_cast<std::uint32_t>(value);
  std::uint64_t digest = 0;
  for (const Channel c : value) digest = digest * 65'599 + bits_of(c);
  return digest;
}

/// Compares a subject's map with the true one; an empty map counts as declined.
Finding compared(MapForm form, const std::vector<Rgba>& expected, const std::vector<Rgba>& got,
                 std::uint32_t tolerance);

/// The law on cases that its subjects support, which its domain names, up to their highest level.
Law within_support(Law law);

using MapBaker = MapBakerOf<std::uint8_t>;
inline MapBaker& map_baker(Baking& f, MapForm form) { return form == MapForm::faces ? f.faces : f.vertices; }
inline const MapBaker& map_baker(const Baking& f, MapForm form) {
  return form == MapForm::faces ? f.faces : f.vertices;
}

/// Up to eight elements of a map to judge: the first, the last, and up to six between, which depend on `salt`.
std::vector<std::uint32_t> judged_at(std::uint64_t count, std::uint64_t salt);

/// Compares both maps of a case with the true ones at the elements judged_at().  `baker(form)`: the subject's baker.
template <class Channel, class Baker>
Finding judged(const BakeCaseOf<Channel>& one, Level n, std::uint32_t tolerance, Baker baker) {
  Finding found;
  for (const MapForm form : {MapForm::faces, MapForm::vertices}) {
    const std::vector<RgbaOf<Channel>> got = baker(form)(one, n);
    const std::uint64_t count = map_size(form, n);
    if (got.empty()) return {.declined = true};
    if (got.size() != count) return wrong(fmt::format("{} values", count), fmt::format("{}", got.size()));
    const std::uint64_t salt = bits_of(one.picture.texels[0][0]) + 7u * one.picture.width;
    for (const std::uint32_t k : judged_at(count, salt)) {
      const RgbaOf<Channel> expected = exact_at(form, one, n, k);
      const Match here = match(expected, got[k], tolerance);
      if (here == Match::wrong)
        return wrong(fmt::format("{} at {}", text_of(expected), name_of(form, k)), text_of(got[k]));
      found.allowed = found.allowed || here == Match::within;
      found.answer = found.answer * 31 + digest_of(got[k]);
    }
  }
  return found;
}

/// A mutant that bakes another case, changed by `change`.
std::function<void(Functions&)> bakes_another(MapForm form, std::function<void(BakeCase&)> change);
/// A mutant that rounds down a value in the middle between two codes.
std::function<void(Functions&)> rounds_half_down(MapForm form);
/// A mutant that rounds the mean of level 0's face up if 10^-9 of a code more would round up: an epsilon against the
/// rounding of binary64.
std::function<void(Functions&)> rounds_near_halves_up();
/// A mutant that averages the texels whose centres lie in the micro-triangle, or takes the texel under its centroid.
std::function<void(Functions&)> averages_centres();
/// A mutant that computes positions in binary32, as p0 + (p1 - p0) u + (p2 - p0) v.
std::function<void(Functions&)> places_in_floats();
/// A mutant that weighs all parts of a segment equally if the triangle is a segment.
std::function<void(Functions&)> spreads_evenly();
/// A mutant that takes the mean of the sampler's values at the three corners.
std::function<void(Functions&)> averages_corners();

std::vector<Law> bake_map_laws();
std::vector<Law> bake_texel_laws();
std::vector<Law> bake_relation_laws();
std::vector<Law> bake_error_laws();
std::vector<Law> plan_laws();

/// Whether fitted() leaves the case as it is.
bool covers(const BakingSupport& support, const BakeCase& one);

/// The case with each unsupported setting replaced by a supported one, chosen by the case's coordinates.
BakeCase fitted(const BakingSupport& support, BakeCase one);

/// The case fitted to a subject's support.
inline BakeCase fitted_case(const AttributeSubject& s, const BakeCase& one) {
  return fitted(s.functions.baking.support, one);
}

/// The restrictions as text, "linear and srgb; clamp; within 1 code"; empty if there are none.
std::string text_of(const BakingSupport& support);

}  // namespace mmverify::proofs::attribute
