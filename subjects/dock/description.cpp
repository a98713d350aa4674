#include "subjects/dock/description.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace mmverify::dock {
namespace {

/// Whether a set has only values below `values`.
bool within(std::uint32_t set, std::uint32_t values) { return set >> values == 0; }

/// The field that contradicts the header; empty if none does.
std::string contradiction(const mmverify_bake_support_t& s) {
  if (s.max_level > 12) return "max_level is above 12";
  if ((s.formats & 1u) != 0 || !within(s.formats, 3)) return "formats has a bit of no format";
  if ((s.texels & 1u) != 0 || !within(s.texels, 4)) return "texels has a bit of no texel type";
  if (!within(s.filters, 2)) return "filters has a bit of no filter";
  if (!within(s.wraps, 5)) return "wraps has a bit of no addressing mode";
  if (!within(s.alpha_modes, 2)) return "alpha_modes has a bit of no alpha mode";
  if (s.max_side != 0 && (s.max_side < 4 || s.max_side > 16384))
    return "max_side is neither 0 nor 4 to 16384";
  if (!within(s.restrictions, 5)) return "restrictions has a bit of no restriction";
  if (s.fixed_cutoff != 0 && !(s.fixed_cutoff >= 0x1p-8f && s.fixed_cutoff <= 1))
    return "fixed_cutoff is neither 0 nor 1/256 to 1";
  if (s.opaque > MMVERIFY_OPAQUE_ABOVE_CUTOFF || s.contact > MMVERIFY_OPEN_MICRO_TRIANGLES ||
      s.unknown > MMVERIFY_UNKNOWN_TRANSPARENT)
    return "opaque, contact or unknown has a value of no rule";
  if (!(std::isfinite(s.uv_min) && std::isfinite(s.uv_max)) ||
      ((s.uv_min != 0 || s.uv_max != 0) && !(s.uv_min < s.uv_max)))
    return "uv_min is not below uv_max";
  if (s.weight_bits > 23 || s.coordinate_bits > 23) return "weight_bits or coordinate_bits is above 23";
  return {};
}

std::string contradiction(const mmverify_attribute_support_t& s) {
  if (s.max_level > 12) return "max_level is above 12";
  if (!within(s.meanings, 4)) return "meanings has a bit of no meaning";
  if (!within(s.filters, 2)) return "filters has a bit of no filter";
  if (!within(s.wraps, 5)) return "wraps has a bit of no addressing mode";
  if ((s.restrictions & ~MMVERIFY_BAKE_SAME_WRAPS) != 0) return "restrictions has a bit of no restriction";
  if (s.tolerance > 16) return "tolerance is above 16";
  return {};
}

}  // namespace

bool description_is_whole(const Description& d) {
  return std::memchr(d.name, 0, sizeof d.name) != nullptr &&
         std::memchr(d.runs_on, 0, sizeof d.runs_on) != nullptr &&
         std::all_of(d.has.begin(), d.has.end(), [](std::uint8_t one) { return one <= 1; });
}

std::string description_fault(const Description& d) {
  if (d.max_level > 16) return "its max_level is above 16";
  if ((d.flags & MMVERIFY_CORNERS_OF_CHILDREN) != 0 && (d.flags & MMVERIFY_CORNERS_BASE_U_V) != 0)
    return "its flags declare two orders of corners";
  if (const std::string wrong = contradiction(d.bake_support); !wrong.empty())
    return "its bake_support: " + wrong;
  if (const std::string wrong = contradiction(d.attribute_support); !wrong.empty())
    return "its attribute_support: " + wrong;
  if (std::count(d.has.begin(), d.has.end(), 1) == 0) return "all its entry points are null";
  return {};
}

}  // namespace mmverify::dock
