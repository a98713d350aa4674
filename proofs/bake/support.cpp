#include "proofs/bake/support.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <cmath>
#include <limits>

#include "proofs/bake/domains/threshold.hpp"

namespace mmverify::proofs::bake {
namespace {

/// One of the values 0..count-1 that are in the set; `value` itself if it is.
template <class Value>
Value one_of(Set set, Value value, unsigned count, std::uint64_t salt) {
  if (set.has(value)) return value;
  std::vector<Value> all;
  for (unsigned k = 0; k < count; ++k)
    if (set.has(k)) all.push_back(static_cast<Value>(k));
  return all.empty() ? value : all[salt % all.size()];
}

std::uint32_t fitting_side(const Support& support, std::uint32_t side) {
  side = std::min(side, support.max_side);
  return support.powers_of_two ? std::bit_floor(side) : side;
}

void fit_texture(const Support& support, Case& one, std::uint64_t salt) {
  const std::uint32_t width = fitting_side(support, one.width), height = fitting_side(support, one.height),
                      chain = static_cast<std::uint32_t>(std::bit_width(std::max(width, height))),
                      mips = std::min({one.mips, support.max_mips, std::max(chain, 1u)});
  one = resized(std::move(one), width, height, mips, one_of(support.texels, one.texel, 3, salt)).value();
}

/// Three coordinates into [low, high]: halved until they fit, then moved to one end, the other or between.
void fit_axis(Case& one, std::size_t axis, double low, double high, std::uint64_t salt) {
  std::array<double, 3> x{};
  for (std::size_t k = 0; k < 3; ++k) x[k] = one.uv[2 * k + axis];
  auto [least, most] = std::minmax({x[0], x[1], x[2]});
  if (least >= low && most <= high) return;
  double scale = 1;
  while ((most - least) * scale > high - low) scale /= 2;
  const double room = (high - low) - (most - least) * scale,
               from = low + room * static_cast<double>(salt % 3) / 2;
  for (std::size_t k = 0; k < 3; ++k)
    one.uv[2 * k + axis] = static_cast<float>(std::clamp((x[k] - least) * scale + from, low, high));
}

double range_of_texels(const Case& one) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  const auto take = [&](std::uint32_t bits) {
    least = std::min(least, value_of(one.texel, bits));
    most = std::max(most, value_of(one.texel, bits));
  };
  for (const std::uint32_t bits : one.alpha) take(bits);
  if (one.wrap_u == Wrap::clamp_to_border || one.wrap_v == Wrap::clamp_to_border) take(one.border);
  return most - least;
}

/// Bilinear sampling in fixed point, by how much it may be off; rounded up.
float slack_of(const Support& support, const Case& one) {
  const auto unit = [](std::uint32_t bits) {
    return bits == 0 ? 0 : std::ldexp(1.0, -static_cast<int>(bits));
  };
  const double slack = (unit(support.weight_bits) + unit(support.coordinate_bits)) * range_of_texels(one) *
                       double{one.factor} * double{one.vertex_factor};
  return slack == 0 ? 0 : std::nextafter(static_cast<float>(slack), std::numeric_limits<float>::infinity());
}

}  // namespace

bool Support::whole() const {
  Support any;
  any.max_level = max_level;
  any.two_state = two_state;
  any.four_state = four_state;
  any.unknown = unknown;
  any.moving = moving;
  any.updates = updates;
  return *this == any;
}

std::string Support::text() const {
  std::vector<std::string> said;
  const auto set = [&said](Set values, std::initializer_list<const char*> names) {
    std::vector<std::string> some;
    unsigned value = 0;
    for (const char* name : names)
      if (values.has(value++)) some.emplace_back(name);
    if (some.size() != names.size()) said.push_back(fmt::format("{}", fmt::join(some, " and ")));
  };
  const auto say = [&said](bool so, std::string text) {
    if (so) said.push_back(std::move(text));
  };
  set(texels, {"8 bits", "16 bits", "binary32"});
  set(filters, {"bilinear", "nearest"});
  set(wraps, {"repeat", "mirror", "clamp", "border", "mirror-once"});
  say(same_wraps, "u and v addressed alike");
  say(!blend, "MASK");
  say(!mask, "BLEND");
  say(max_side < 16384, fmt::format("sides up to {}", max_side));
  say(powers_of_two, "sides that are powers of two");
  say(max_mips < 15, max_mips == 1 ? std::string("one mip") : fmt::format("up to {} mips", max_mips));
  say(!factors, "no factors");
  say(!margins, "no margins");
  if (fixed_cutoff)
    said.push_back(
        fmt::format("cutoff {}", static_cast<double>(fixed_cutoff->numerator) / fixed_cutoff->denominator));
  say(float_cutoffs && !fixed_cutoff, "cutoffs of binary32");
  say(above, "opaque above the cutoff");
  say(contact == spec::bake::Contact::open, "open micro-triangles");
  say(bounded(), fmt::format("coordinates in [{}, {}]", uv_min, uv_max));
  say(weight_bits != 0, fmt::format("weights of {} bits", weight_bits));
  say(coordinate_bits != 0, fmt::format("coordinates with {} bits of fraction", coordinate_bits));
  return fmt::format("{}", fmt::join(said, ", "));
}

Cutoff float_cutoff(const Cutoff& cutoff) {
  const float x = std::min(1.0f, static_cast<float>(double{static_cast<double>(cutoff.numerator)} /
                                                    static_cast<double>(cutoff.denominator)));
  if (x < 0x1p-9f) return {0, 1};
  if (x < 0x1p-8f) return {1, 256};
  // A binary32 number in [2^-8, 1] over 2^31 is whole.
  std::uint32_t numerator = static_cast<std::uint32_t>(std::ldexp(double{x}, 31)), denominator = 1u << 31;
  const int common = std::min(std::countr_zero(numerator), 31);
  return {numerator >> common, denominator >> common};
}

bool covers(const Support& s, const Case& one) {
  const auto fits = [&](std::uint32_t side) { return fitting_side(s, side) == side; };
  const auto in_range = [&](float x) { return !s.bounded() || (x >= s.uv_min && x <= s.uv_max); };
  return s.texels.has(one.texel) && s.filters.has(one.filter) &&
         !(s.coordinate_bits != 0 && one.filter == Filter::nearest) && s.wraps.has(one.wrap_u) &&
         s.wraps.has(one.wrap_v) && !(s.same_wraps && one.wrap_u != one.wrap_v) && fits(one.width) &&
         fits(one.height) && one.mips <= s.max_mips &&
         (s.factors || (one.factor == 1 && one.vertex_factor == 1)) && (s.margins || one.margin == 0) &&
         (s.moving || one.travel == std::array<float, 2>{}) && (s.updates || one.change.boxes.empty()) &&
         (one.blend ? s.judges_blend() : s.mask) &&
         (one.blend || !s.fixed_cutoff || one.cutoff == *s.fixed_cutoff) &&
         (one.blend || s.fixed_cutoff || !s.float_cutoffs || one.cutoff == float_cutoff(one.cutoff)) &&
         std::all_of(one.uv.begin(), one.uv.end(), in_range);
}

Case fitted(const Support& support, Case one, std::uint64_t salt) {
  if (support.whole()) return one;
  fit_texture(support, one, salt);
  one.filter = one_of(support.filters, one.filter, 2, salt);
  // A coordinate that is rounded may fall to another texel: what nearest filtering then samples, nothing says.
  if (support.coordinate_bits != 0 && support.filters.has(Filter::bilinear)) one.filter = Filter::bilinear;
  one.wrap_u = one_of(support.wraps, one.wrap_u, 5, salt);
  one.wrap_v = support.same_wraps ? one.wrap_u : one_of(support.wraps, one.wrap_v, 5, salt / 5);
  if (!support.factors) one.factor = one.vertex_factor = 1;
  if (!support.margins) one.margin = 0;
  if (one.blend ? !support.judges_blend() : !support.mask) one.blend = !support.mask;
  if (support.fixed_cutoff)
    one.cutoff = *support.fixed_cutoff;
  else if (support.float_cutoffs)
    one.cutoff = float_cutoff(one.cutoff);
  if (support.bounded())
    for (std::size_t axis = 0; axis < 2; ++axis)
      fit_axis(one, axis, support.uv_min, support.uv_max, salt / (axis == 0 ? 1 : 3));
  one.rules = {support.above, support.contact,
               one.blend || support.exact_sampling() ? 0 : slack_of(support, one)};
  return one;
}

}  // namespace mmverify::proofs::bake
