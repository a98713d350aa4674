// A baker of opacity micromaps, written from the header, the design and the rules of Vulkan's samplers alone.
// It is exact: whole numbers decide whatever binary64 leaves open.  One fault at a time can be built in.
#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "sdk/mmverify_subject.h"
#include "tests/foreign/fault.hpp"

namespace {

enum Fault {
#define MMVERIFY_FAULT(name, wrong, laws) name,
#include "tests/foreign/bake_faults.def"
#undef MMVERIFY_FAULT
};
constexpr const char* fault_names[] = {
#define MMVERIFY_FAULT(name, wrong, laws) #name,
#include "tests/foreign/bake_faults.def"
#undef MMVERIFY_FAULT
};
const std::optional<int> fault = mmverify::tests::foreign::chosen_fault(fault_names);
bool has(Fault f) { return fault == static_cast<int>(f); }

// ---------------------------------------------------------------------------------------------- numbers

__extension__ typedef __int128 Wide;
namespace mp = boost::multiprecision;
using Big = mp::number<mp::cpp_int_backend<>, mp::et_off>;
using Index = std::int64_t;

/// Thrown where a case is beyond what is supported here: not finite, 2^60 texels away, millions of texels.
struct Declined {};

int sign(const Big& x) { return x.sign(); }
int sign(Wide x) { return (x > 0) - (x < 0); }
double real(const Big& x) { return x.convert_to<double>(); }
double real(Wide x) { return static_cast<double>(x); }

int bits(const Big& x) { return x == 0 ? 0 : static_cast<int>(mp::msb(mp::abs(x))) + 1; }

template <class T>
T to(const Big& x) {
  if constexpr (std::is_same_v<T, Big>) {
    return x;
  } else {
    const Big magnitude = mp::abs(x);
    const auto low = static_cast<std::uint64_t>(magnitude & 0xffffffffffffffffu);
    const auto high = static_cast<std::uint64_t>(magnitude >> 64);
    const Wide whole = (static_cast<Wide>(high) << 64) + static_cast<Wide>(low);
    return x.sign() < 0 ? -whole : whole;
  }
}
template <class T>
T to(Wide x) {
  if constexpr (std::is_same_v<T, Big>) {
    const bool below = x < 0;
    const Wide m = below ? -x : x;
    Big whole = static_cast<std::uint64_t>(m >> 64);
    whole <<= 64;
    whole += static_cast<std::uint64_t>(m);
    return below ? Big(-whole) : whole;
  } else {
    return x;
  }
}

template <class T>
T floor_div(const T& a, const T& b) {  // b > 0
  T q = a / b;
  if (sign(a) < 0 && q * b != a) q -= 1;
  return q;
}
template <class T>
T ceil_div(const T& a, const T& b) {
  return -floor_div(T(-a), b);
}
template <class T>
Index index_of(const T& x) {
  if (x > T(Index{1} << 61)) return Index{1} << 61;
  if (x < T(-(Index{1} << 61))) return -(Index{1} << 61);
  return static_cast<Index>(x);
}

/// mantissa 2^exponent, the mantissa odd or 0.
struct Dyadic {
  Big mantissa = 0;
  int exponent = 0;
};
template <class F>
Dyadic dyadic(F x) {
  if (!std::isfinite(x)) throw Declined{};
  if (x == 0) return {};
  int e = 0;
  const double m = std::frexp(static_cast<double>(x), &e);
  auto whole = static_cast<std::int64_t>(std::ldexp(m, 53));
  e -= 53;
  while (whole % 2 == 0) {
    whole /= 2;
    ++e;
  }
  return {Big(whole), e};
}
Big shifted(const Dyadic& d, int up) {  // d 2^up, which is whole
  return d.mantissa == 0 ? Big(0) : Big(d.mantissa << static_cast<unsigned>(d.exponent + up));
}

// ----------------------------------------------------------------------------------- texels, thresholds

enum Sign : unsigned { negative = 1, zero = 2, positive = 4 };
Sign sign_bit(int s) { return s < 0 ? negative : s > 0 ? positive : zero; }

/// What alpha is compared with: factors x texel against numerator / denominator.
struct Threshold {
  Big numerator, denominator;
  bool is_mask = false;
};

/// The texels of one mip and, last, the border, as whole numbers whose sign is that of alpha - threshold and
/// which differ from that by one positive factor.
struct Field {
  std::vector<Wide> small;
  std::vector<Big> large;
  std::vector<double> approximate;  // the same over the greatest: within -1..1
  std::vector<unsigned char> signs;
  bool fits = true;
  int size_bits = 0;

  template <class T>
  T value(std::size_t k) const {
    return fits ? to<T>(small[k]) : to<T>(large[k]);
  }
};

struct Mip {
  Index width = 0, height = 0;
  std::size_t count = 0;  // of texels; the border comes after them
  std::vector<Field> fields;
};

Index next_size(Index size, Fault odd_up) {
  return has(odd_up) && size > 1 ? (size + 1) / 2 : std::max<Index>(1, size / 2);
}

float texel_float(float x) {
  if (has(float_clamped)) return std::min(1.0F, std::max(0.0F, x));
  if (has(float_negative_is_0) && x < 0) return 0;
  if (has(float_to_16_bits) && x >= 0 && x <= 1) return std::round(x * 65535.0F) / 65535.0F;
  if (has(float_flushes) && std::fpclassify(x) == FP_SUBNORMAL) return 0;
  if (has(float_low_bit)) {
    std::uint32_t word;
    std::memcpy(&word, &x, 4);
    word &= ~1u;
    std::memcpy(&x, &word, 4);
  }
  return x;
}

std::size_t bytes_of(const mmverify_bake_case_t& c) {
  return c.texel == MMVERIFY_UNORM8 ? 1 : c.texel == MMVERIFY_UNORM16 ? 2 : 4;
}

/// All texels of a mip, and the border, as whole numbers over one scale: numerators and the power of two.
struct Stored {
  std::vector<Big> values;
  int exponent = 0;  // alpha = value 2^exponent / full
  Big full = 1;
};

Stored read_texels(const mmverify_bake_case_t& c, const unsigned char* from, std::size_t count,
                   bool later_mip) {
  Stored s;
  s.values.reserve(count + 1);
  std::uint32_t border = c.border;
  if (has(border_of_mips_is_0) && later_mip) border = 0;
  if (c.texel == MMVERIFY_UNORM8) {
    s.full = has(unorm8_by_256) ? 256 : 255;
    for (std::size_t k = 0; k < count; ++k) s.values.emplace_back(from[k]);
    s.values.emplace_back(border & 0xffu);
  } else if (c.texel == MMVERIFY_UNORM16) {
    s.full = has(unorm16_high_byte) ? 255 : has(unorm16_by_65536) ? 65536 : 65535;
    const auto value = [](unsigned word) { return has(unorm16_high_byte) ? word >> 8 : word; };
    for (std::size_t k = 0; k < count; ++k) {
      std::uint16_t word;
      std::memcpy(&word, from + 2 * k, 2);
      s.values.emplace_back(value(word));
    }
    s.values.emplace_back(has(border_16_as_8) ? (border & 0xffu) * 257u : value(border & 0xffffu));
  } else {
    std::vector<Dyadic> all;
    all.reserve(count + 1);
    for (std::size_t k = 0; k <= count; ++k) {
      float x;
      if (k == count) {
        std::memcpy(&x, &border, 4);
        if (has(border_of_floats_is_0)) x = 0;
        const bool used = c.wrap_u == MMVERIFY_CLAMP_TO_BORDER || c.wrap_v == MMVERIFY_CLAMP_TO_BORDER;
        if (!used) x = 0;
      } else {
        std::memcpy(&x, from + 4 * k, 4);
      }
      all.push_back(dyadic(texel_float(x)));
    }
    s.exponent = 0;
    for (const Dyadic& d : all)
      if (d.mantissa != 0) s.exponent = std::min(s.exponent, d.exponent);
    for (const Dyadic& d : all) s.values.push_back(shifted(d, -s.exponent));
  }
  return s;
}

Big power(int e) { return Big(1) << static_cast<unsigned>(e); }

float factor_of(float x) { return has(factor_above_1) && x > 1 ? 1.0F : x; }

/// Both factors as one number.
Dyadic product_of_factors(const mmverify_bake_case_t& c) {
  const float f = factor_of(c.factor);
  float g = factor_of(c.vertex_factor);
  if (has(vertex_factor_lost) && f != 1.0F) g = 1;
  if (has(vertex_factor_of_blend_lost) && c.alpha_mode == MMVERIFY_BLEND) g = 1;
  if (has(factors_in_float)) return dyadic(f * g);
  if (has(factors_in_16_bits))
    return dyadic(std::round(static_cast<double>(f) * static_cast<double>(g) * 65536) / 65536);
  const Dyadic a = dyadic(f), b = dyadic(g);
  if (a.mantissa == 0 || b.mantissa == 0) return {};
  return {a.mantissa * b.mantissa, a.exponent + b.exponent};
}

Field field_of(const mmverify_bake_case_t& c, const Stored& s, const Threshold& t, bool at_centroid) {
  // factor value 2^e / full - n / d has the sign of  value (m 2^e d) - full n, both times a power of two
  const Dyadic f = product_of_factors(c);
  const auto scale_and_offset = [&](const Dyadic& factor) {
    Big scale = factor.mantissa * t.denominator, offset = s.full * t.numerator;
    const int e = factor.exponent + s.exponent;
    if (e >= 0)
      scale <<= static_cast<unsigned>(e);
    else
      offset <<= static_cast<unsigned>(-e);
    Big common = mp::gcd(mp::abs(scale), mp::abs(offset));
    if (common == 0) common = 1;
    return std::pair<Big, Big>(scale / common, offset / common);
  };
  auto [scale, offset] = scale_and_offset(f);
  if (has(centroid_without_factor) && at_centroid && c.alpha_mode == MMVERIFY_BLEND)
    std::tie(scale, offset) = scale_and_offset(Dyadic{1, 0});

  std::vector<Big> values(s.values.size());
  const bool rounds = has(factor_times_texel_in_float) && (c.factor != 1.0F || c.vertex_factor != 1.0F);
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k > 0 && s.values[k] == s.values[k - 1])
      values[k] = values[k - 1];
    else
      values[k] = s.values[k] * scale - offset;
  }
  if (rounds) {
    const double full = real(s.full), factors = std::ldexp(real(f.mantissa), f.exponent);
    int least = 0;
    std::vector<Dyadic> all;
    for (const Big& v : s.values) {
      all.push_back(dyadic(static_cast<float>(std::ldexp(real(v), s.exponent) / full * factors)));
      least = std::min(least, all.back().exponent);
    }
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k] = shifted(all[k], -least) * t.denominator - (t.numerator << static_cast<unsigned>(-least));
  }
  if (has(border_without_factor)) {
    const auto [plain, under] = scale_and_offset(Dyadic{1, 0});
    // brought to the scale of the others, which is at least that of both products
    const Big other = s.values.back() * plain - under;
    if (offset != 0 && under != 0) {
      const Big a = mp::abs(offset), b = mp::abs(under);
      for (Big& v : values) v *= b;
      values.back() = other * a;
    } else {
      values.back() = other;
    }
  }
  if (has(cutoff_0) && t.is_mask && t.numerator == 0)
    for (Big& v : values)
      if (v == 0) v = -1;

  Field field;
  Big greatest = 0;
  for (const Big& v : values) {
    if (v > greatest) greatest = v;
    if (-v > greatest) greatest = -v;
  }
  field.size_bits = bits(greatest);
  field.fits = field.size_bits <= 100;
  const double unit = greatest == 0 ? 1 : real(greatest);
  for (const Big& v : values) {
    field.approximate.push_back(real(v) / unit);
    field.signs.push_back(static_cast<unsigned char>(sign_bit(v.sign())));
    if (field.fits) field.small.push_back(to<Wide>(v));
  }
  if (!field.fits) field.large = std::move(values);
  return field;
}

Threshold threshold_of_mask(const mmverify_bake_case_t& c, const Big& full) {
  Big n = c.cutoff_numerator, d = c.cutoff_denominator;
  if (d == 0) throw Declined{};
  if (has(cutoff_in_float) || has(cutoff_in_double)) {
    double q = static_cast<double>(c.cutoff_numerator) / static_cast<double>(c.cutoff_denominator);
    if (has(cutoff_in_float))
      q = static_cast<double>(static_cast<float>(c.cutoff_numerator) /
                              static_cast<float>(c.cutoff_denominator));
    const Dyadic r = dyadic(q);
    const int down = std::max(0, -r.exponent);
    n = shifted(r, down);
    d = power(down);
  }
  if (has(cutoff_in_31_bits) && c.cutoff_denominator >= 0x80000000u) {
    n = n / 2;
    d = d / 2;
  }
  if (has(cutoff_in_texel_steps) && c.texel != MMVERIFY_FLOAT32) {
    n = (n * full + d - 1) / d;
    d = full;
  }
  if (has(cutoff_numerator_in_8_bits)) n = c.cutoff_numerator & 255u;
  if (has(cutoff_to_a_byte)) {
    n = static_cast<unsigned>(2 * Big(256) * n / d + 1) / 2 & 255u;
    d = 256;
  }
  if (has(cutoff_shift_overflows)) {
    n = (c.cutoff_numerator << 24) / c.cutoff_denominator;
    d = 1u << 24;
  }
  if (has(cutoff_high_greater) && 4 * n >= 3 * d && n <= d) n = d - n;
  if (has(cutoff_above_1) && n > d) n = d;
  return {n, d, true};
}

std::vector<Threshold> thresholds_of(const mmverify_bake_case_t& c, const Big& full) {
  // MASK: one for all.  BLEND: O, T, and the centroid's.
  if (c.alpha_mode == MMVERIFY_MASK) return {threshold_of_mask(c, full)};
  Threshold opaque{1, 1}, clear{0, 1}, centre{1, 2};
  if (has(blend_O_at_254)) opaque = {254, 255};
  if (has(blend_T_below_a_step)) clear = {1, 255};
  if (has(blend_uses_cutoff) && c.cutoff_numerator != 0 && c.cutoff_denominator != 0)
    opaque = {c.cutoff_numerator, c.cutoff_denominator};
  if (has(centroid_blend_cutoff) && c.cutoff_denominator != 0)
    centre = {c.cutoff_numerator, c.cutoff_denominator};
  if (has(centroid_blend_1) || (has(two_state_blend_1) && c.format == MMVERIFY_2_STATE)) centre = {1, 1};
  return {opaque, clear, centre};
}

// --------------------------------------------------------------------------------------------- addressing

/// Where index i lies along an axis of `size` texels; -1: the border.
Index wrapped(Index i, Index size, unsigned mode, bool along_u) {
  const auto modulo = [](Index a, Index n) { return ((a % n) + n) % n; };
  switch (mode) {
    case MMVERIFY_REPEAT:
      if (has(repeat_of_negatives)) return std::abs(i % size);
      if (has(repeat_by_mask)) return i & (size - 1);
      return modulo(i, size);
    case MMVERIFY_MIRRORED_REPEAT: {
      if (has(mirror_about_centre) && size > 1) {
        const Index k = modulo(i, 2 * size - 2);
        return k < size ? k : 2 * size - 2 - k;
      }
      if (has(mirror_parity_of_negatives) && i < -size) return modulo(i, size);
      const Index k = modulo(i, 2 * size);
      return k < size ? k : 2 * size - 1 - k;
    }
    case MMVERIFY_CLAMP_TO_EDGE:
      return std::clamp<Index>(i, 0, size - 1);
    case MMVERIFY_CLAMP_TO_BORDER:
      if (has(border_a_texel_late) && along_u && i == size) return size - 1;
      return i < 0 || i >= size ? -1 : i;
    default: {
      if (has(mirror_once_is_clamp_far) && i < -size) return 0;
      if (i < 0) i = has(mirror_once_negative) ? -i : -1 - i;
      return std::min(i, size - 1);
    }
  }
}

struct Range {
  Index low, high;
};
constexpr Index endless = Index{1} << 62;

/// Cells [i, i+1] (bilinear: between texel centres; nearest: texels) below low and above high look like low
/// and high themselves.
Range distinct(Index size, unsigned mode, bool nearest) {
  switch (mode) {
    case MMVERIFY_CLAMP_TO_EDGE:
      return nearest ? Range{0, size - 1} : Range{-1, size - 1};
    case MMVERIFY_CLAMP_TO_BORDER:
      return nearest ? Range{-1, size} : Range{-2, size};
    case MMVERIFY_MIRROR_CLAMP_TO_EDGE:
      return nearest ? Range{-size, size - 1} : Range{-size - 1, size - 1};
    default:
      return {-endless, endless};
  }
}
Index period(Index size, unsigned mode) {
  if (mode == MMVERIFY_MIRRORED_REPEAT && !has(interior_one_period)) return 2 * size;
  if (mode == MMVERIFY_MIRRORED_REPEAT || mode == MMVERIFY_REPEAT) return size;
  return endless;
}

// ----------------------------------------------------------------------------------------------- geometry

template <class T>
struct Point {
  T x, y;
  bool operator==(const Point&) const = default;
};

template <class T>
T cross(const Point<T>& o, const Point<T>& a, const Point<T>& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// The convex hull, counter-clockwise, without points on its sides; of a line its ends, of a point it.
template <class T>
std::vector<Point<T>> hull(std::vector<Point<T>> all) {
  std::sort(all.begin(), all.end(),
            [](const Point<T>& a, const Point<T>& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  if (all.size() < 3) return all;
  std::vector<Point<T>> out;
  for (int half = 0; half < 2; ++half) {
    const std::size_t base = out.size();
    for (const Point<T>& p : all) {
      while (out.size() >= base + 2 && sign(cross(out[out.size() - 2], out.back(), p)) <= 0) out.pop_back();
      out.push_back(p);
    }
    out.pop_back();
    std::reverse(all.begin(), all.end());
  }
  return out;
}

/// A base triangle in the texels of one mip, as seen from texel `origin`, in units of 1/unit texel: the
/// micro-vertex (a, b) lies at start + a along_u + b along_v.
struct Placed {
  Big start[2], along_u[2], along_v[2], unit, margin[2];
  Index origin[2];
  int size_bits;
};

bool is_far(const mmverify_bake_case_t& c) {
  return std::any_of(c.uv, c.uv + 6, [](float x) { return std::abs(x) > 1000; });
}

Placed place(const mmverify_bake_case_t& c, Index width, Index height, unsigned mip, bool nearest) {
  std::array<Dyadic, 6> uv;
  float whole[2] = {};
  if (has(far_repeats_in_float) && is_far(c))
    for (int a = 0; a < 2; ++a) whole[a] = std::floor(c.uv[a] / 2) * 2;
  for (std::size_t k = 0; k < 6; ++k) {
    float x = c.uv[k];
    if (!std::isfinite(x)) throw Declined{};
    if (has(far_repeats_in_float) && is_far(c)) x = x - whole[k % 2];
    if (has(far_repeats_off_each_vertex)) x = std::clamp(x, -0x1p22F, 0x1p22F);
    uv[k] = dyadic(x);
  }
  float margin = c.margin;
  if (!(margin >= 0)) throw Declined{};
  if (has(margin_of_first_mip)) margin = std::ldexp(margin, -static_cast<int>(mip));
  if (has(margin_in_first_mip_only) && mip > 0) margin = 0;
  if (has(margin_not_nearest) && nearest) margin = 0;
  if (has(margin_up_to_1)) margin = std::min(margin, 1.0F);
  if (has(margin_up_to_4)) margin = std::min(margin, 4.0F);
  if (has(margin_fraction) && margin > 1) margin -= std::floor(margin);
  if (has(margin_over_2) && margin > 2) margin = 0;
  if (has(margin_over_size) && 2 * margin > static_cast<float>(width)) margin = 0;
  if (has(margin_in_64ths)) margin = std::round(margin * 64) / 64;
  if (has(margin_not_of_lines)) {
    const auto d = [&](int k) { return static_cast<double>(c.uv[k]); };
    if ((d(2) - d(0)) * (d(5) - d(1)) == (d(3) - d(1)) * (d(4) - d(0))) margin = 0;
  }
  const Dyadic grown = dyadic(margin);
  Dyadic grown_y = grown;
  if (has(margin_in_uv_of_width))
    grown_y = dyadic(static_cast<double>(margin) * static_cast<double>(height) / static_cast<double>(width));
  if (has(margin_along_u_only)) grown_y = {};

  int fraction = 1;
  for (const Dyadic& d : uv) fraction = std::max(fraction, -d.exponent);
  fraction = std::max({fraction, -grown.exponent, -grown_y.exponent});

  Placed p;
  const auto level = static_cast<int>(c.level);
  p.unit = power(fraction + level);
  p.margin[0] = shifted(grown, fraction + level);
  p.margin[1] = shifted(grown_y, fraction + level);
  p.size_bits = bits(p.unit);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const Index size = axis == 0 ? width : height;
    bool half = !nearest || has(nearest_half_texel);
    if (has(bilinear_no_half_texel_when_1) && size == 1 &&
        (axis == 0 ? c.wrap_u : c.wrap_v) == MMVERIFY_CLAMP_TO_BORDER)
      half = false;
    Big v[3];
    for (std::size_t k = 0; k < 3; ++k) v[k] = shifted(uv[2 * k + axis], fraction) * size;
    p.start[axis] = (v[0] << c.level) - (half ? Big(p.unit / 2) : Big(0));
    p.along_u[axis] = v[1] - v[0];
    p.along_v[axis] = v[2] - v[0];
    const bool turned = has(curve_exchanges_uv) || (has(curve_exchanges_uv_of_8) && c.level >= 8);
    if (turned) std::swap(p.along_u[axis], p.along_v[axis]);
    const Big far_u = p.start[axis] + (p.along_u[axis] << c.level),
              far_v = p.start[axis] + (p.along_v[axis] << c.level);
    const Big least = std::min({p.start[axis], far_u, far_v});
    const Big base = floor_div(least, p.unit);
    if (bits(base) > 60) throw Declined{};
    p.origin[axis] = static_cast<Index>(base);
    p.start[axis] -= base * p.unit;
    const Big most =
        std::max({p.start[axis], Big(far_u - base * p.unit), Big(far_v - base * p.unit)}) + p.margin[axis];
    if (bits(floor_div(most, p.unit)) > 60) throw Declined{};
    p.size_bits = std::max(p.size_bits, bits(most));
    const unsigned mode = axis == 0 ? c.wrap_u : c.wrap_v;  // lines of clamped axes may lie far off
    if (period(size, mode) == endless)
      p.size_bits = std::max(p.size_bits, bits(mp::abs(base) + size + 2) + bits(p.unit));
  }
  return p;
}

/// A micro-triangle, or a node above it, by three micro-vertices in units of the level.
struct Node {
  std::array<std::array<std::uint32_t, 2>, 3> corners;
};

enum class Aim { both_sides, any_negative, any_positive };

bool settled(unsigned seen, Aim aim) {
  switch (aim) {
    case Aim::both_sides:
      return (seen & negative) != 0 && (seen & (zero | positive)) != 0;
    case Aim::any_negative:
      return (seen & negative) != 0;
    default:
      return (seen & positive) != 0;
  }
}

/// One mip of one case: all that a micro-triangle is asked.  T: the whole numbers that hold its places.
template <class T>
class Sampled {
 public:
  Sampled(const mmverify_bake_case_t& c, const Mip& mip, unsigned number, bool nearest)
      : case_(c), mip_(mip), number_(number), nearest_(nearest) {
    const Placed p = place(c, mip.width, mip.height, number, nearest);
    for (std::size_t a = 0; a < 2; ++a) {
      start_[a] = to<T>(p.start[a]);
      along_u_[a] = to<T>(p.along_u[a]);
      along_v_[a] = to<T>(p.along_v[a]);
      margin_[a] = to<T>(p.margin[a]);
      origin_[a] = p.origin[a];
    }
    unit_ = to<T>(p.unit);
    unit_real_ = real(unit_);
    place_bits_ = p.size_bits;
    wrap_u_ = c.wrap_u;
    wrap_v_ = c.wrap_v;
    if (has(wrap_v_is_u) || (has(wrap_v_is_u_when_tall) && mip.height > mip.width && mip.height > 8) ||
        (has(mips_wrap_u) && number > 0))
      wrap_v_ = wrap_u_;
    const Range x = distinct(mip.width, wrap_u_, nearest), y = distinct(mip.height, wrap_v_, nearest);
    columns_ = local(x, 0);
    rows_ = local(y, 1);
    along_all_ = period(mip.width, wrap_u_);
    down_all_ = period(mip.height, wrap_v_);
  }

  /// Which signs alpha - threshold has on the closed node, grown by the margin; enough of them for `aim`.
  unsigned signs(const Node& node, const Field& f, Aim aim) const {
    const auto polygon = polygon_of(node);
    if (nearest_) return nearest_signs(polygon, f, aim);
    return bilinear_signs(polygon, f, aim, node);
  }

  /// The sign at the centroid.
  int centroid_sign(const Node& node, const Field& f) const {
    Point<T> sum{T(0), T(0)};
    T unit = unit_ * 3;
    if (has(centroid_is_vertex)) {
      const Point<T> p = vertex(node.corners[0]);
      sum = {p.x * 3, p.y * 3};
    } else {
      for (const auto& k : node.corners) {
        const Point<T> p = vertex(k);
        sum.x += p.x;
        sum.y += p.y;
      }
    }
    if (has(centroid_in_float) || has(centroid_in_double)) {
      // rounded in texture coordinates, as a program that has them in such numbers would
      const T scale = T(1 << 20);
      for (int a = 0; a < 2; ++a) {
        T& s = a == 0 ? sum.x : sum.y;
        const double size = static_cast<double>(a == 0 ? mip_.width : mip_.height);
        const double half = nearest_ ? 0 : 0.5, base = static_cast<double>(origin_[a]);
        double x = (real(s) / (3 * unit_real_) + base + half) / size;
        if (has(centroid_in_float)) x = static_cast<double>(static_cast<float>(x));
        x = x * size - half - base;
        (void)scale;
        s = to<T>(rounded(std::ldexp(x, 40), unit_ * 3));
      }
    }
    const Index i = index_of(floor_div(sum.x, unit)), j = index_of(floor_div(sum.y, unit));
    if (nearest_ || has(centroid_nearest) || (has(two_state_nearest) && case_.format == MMVERIFY_2_STATE)) {
      if (nearest_) return sign_of(f, texel(i, j));
      const Index ii = index_of(floor_div(T(2 * sum.x + unit), T(2 * unit))),
                  jj = index_of(floor_div(T(2 * sum.y + unit), T(2 * unit)));
      return sign_of(f, texel(ii, jj));
    }
    const T x = sum.x - unit * T(i), y = sum.y - unit * T(j);
    // first in binary64: a mean of numbers within -1..1
    const double p = real(x) / real(unit), q = real(y) / real(unit);
    const std::size_t k[4] = {texel(i, j), texel(i + 1, j), texel(i, j + 1), texel(i + 1, j + 1)};
    const auto& g = f.approximate;
    const double top = g[k[0]] + p * (g[k[1]] - g[k[0]]), bottom = g[k[2]] + p * (g[k[3]] - g[k[2]]);
    const double mean = top + q * (bottom - top);
    if (std::abs(mean) > 0x1p-44) return mean < 0 ? -1 : 1;
    const auto exactly = [&]<class E>() {
      const E e = to<E>(unit), u = to<E>(x), v = to<E>(y);
      return sign((e - v) * ((e - u) * f.value<E>(k[0]) + u * f.value<E>(k[1])) +
                  v * ((e - u) * f.value<E>(k[2]) + u * f.value<E>(k[3])));
    };
    if (f.fits && f.size_bits + 2 * bits(to<Big>(unit)) + 4 <= 120)
      return exactly.template operator()<Wide>();
    return exactly.template operator()<Big>();
  }

  /// Alpha at a corner of the node, and whether it has an area (for faults that look at little).
  int corner_sign(const Node& node, const Field& f, std::size_t k) const {
    const Node point{{node.corners[k], node.corners[k], node.corners[k]}};
    const unsigned s = signs_of_point(point, f);
    return (s & negative) != 0 ? -1 : (s & positive) != 0 ? 1 : 0;
  }

 private:
  static Big rounded(double x, const T& unit) {  // x 2^-40 in units
    const Dyadic d = dyadic(x);
    Big whole = d.mantissa * to<Big>(unit);
    const int e = d.exponent - 40;
    return e >= 0 ? Big(whole << static_cast<unsigned>(e)) : Big(whole >> static_cast<unsigned>(-e));
  }

  Range local(Range r, std::size_t axis) const {
    if (r.high == endless) return r;
    return {r.low - origin_[axis], r.high - origin_[axis]};
  }

  Point<T> vertex(const std::array<std::uint32_t, 2>& k) const {
    const T a = T(static_cast<Index>(k[0])), b = T(static_cast<Index>(k[1]));
    Point<T> p{start_[0] + a * along_u_[0] + b * along_v_[0], start_[1] + a * along_u_[1] + b * along_v_[1]};
    if (has(vertices_in_float)) {
      for (int axis = 0; axis < 2; ++axis) {
        T& s = axis == 0 ? p.x : p.y;
        const double size = static_cast<double>(axis == 0 ? mip_.width : mip_.height);
        const double half = nearest_ ? 0 : 0.5, base = static_cast<double>(origin_[axis]);
        double x = (real(s) / unit_real_ + base + half) / size;
        x = static_cast<double>(static_cast<float>(x));
        s = to<T>(rounded(std::ldexp(x * size - half - base, 40), unit_));
      }
    }
    if (has(vertices_in_256ths) && case_.level >= 6) {
      const T step = unit_ / 256;
      if (step > 0)
        p = {floor_div(T(p.x + step / 2), step) * step, floor_div(T(p.y + step / 2), step) * step};
    }
    return p;
  }

  std::vector<Point<T>> polygon_of(const Node& node) const {
    std::vector<Point<T>> all;
    const bool none = margin_[0] == 0 && margin_[1] == 0;
    const bool diamond = has(margin_diamond) || (has(margin_diamond_when_wide) && margin_[0] > unit_);
    for (const auto& k : node.corners) {
      const Point<T> p = vertex(k);
      if (none) {
        all.push_back(p);
      } else if (diamond) {
        all.push_back({p.x - margin_[0], p.y});
        all.push_back({p.x + margin_[0], p.y});
        all.push_back({p.x, p.y - margin_[1]});
        all.push_back({p.x, p.y + margin_[1]});
      } else {
        for (int a = -1; a <= 1; a += 2)
          for (int b = has(margin_one_sided) ? 0 : -1; b <= 1; b += has(margin_one_sided) ? 1 : 2)
            all.push_back({p.x + T(a) * margin_[0], p.y + T(b) * margin_[1]});
      }
    }
    return hull(std::move(all));
  }

  /// Where a texel, counted from the origin, is stored; the border after the last.
  std::size_t texel(Index i, Index j) const {
    Index x = wrapped(i + origin_[0], mip_.width, wrap_u_, true),
          y = wrapped(j + origin_[1], mip_.height, wrap_v_, false);
    if (x < 0 || y < 0) {
      const bool both = has(border_needs_both) && wrap_u_ == MMVERIFY_CLAMP_TO_BORDER &&
                        wrap_v_ == MMVERIFY_CLAMP_TO_BORDER;
      if (!both || (x < 0 && y < 0)) return mip_.count;
      x = x < 0 ? (i + origin_[0] < 0 ? 0 : mip_.width - 1) : x;
      y = y < 0 ? (j + origin_[1] < 0 ? 0 : mip_.height - 1) : y;
    }
    if (has(column_in_8_bits)) x &= 255;
    if (has(column_in_6_bits)) x &= 63;
    if (has(column_in_5_bits)) x &= 31;
    if (has(row_in_5_bits)) y &= 31;
    if (has(rows_from_bottom)) y = mip_.height - 1 - y;
    Index offset = y * (has(stride_is_height) ? mip_.height : mip_.width) + x;
    if (has(stride_is_height)) offset %= static_cast<Index>(mip_.count);
    if (has(offset_in_16_bits)) offset &= 65535;
    return static_cast<std::size_t>(offset);
  }

  static int sign_of(const Field& f, std::size_t k) {
    return (f.signs[k] & negative) != 0 ? -1 : (f.signs[k] & positive) != 0 ? 1 : 0;
  }

  struct Box {
    Index left, right, top, bottom;
  };
  /// The cells that a polygon meets, those that look alike counted once.
  Box cells_of(const std::vector<Point<T>>& polygon) const {
    T left = polygon[0].x, right = left, top = polygon[0].y, bottom = top;
    for (const auto& p : polygon) {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      top = std::min(top, p.y);
      bottom = std::max(bottom, p.y);
    }
    const auto cell = [&](const T& x, Range r) {
      return std::clamp(index_of(floor_div(x, unit_)), r.low, r.high);
    };
    return {cell(left, columns_), cell(right, columns_), cell(top, rows_), cell(bottom, rows_)};
  }

  void spend(Index n) const {
    if (n > Index{1} << 22) throw Declined{};
  }

  // ------------------------------------------------------------------------------------------ nearest

  unsigned nearest_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim) const {
    const Box box = cells_of(polygon);
    spend(box.bottom - box.top);
    unsigned seen = 0;
    Index last = box.bottom;
    if (has(rows_up_to_256)) last = std::min(last, box.top + 255);
    if (has(rows_up_to_16)) last = std::min(last, box.top + 15);
    for (Index j = box.top; j <= last; ++j) {
      // the strip j <= y < j + 1; the first and last distinct rows have no end
      const bool has_low = j > rows_.low, has_high = j < rows_.high;
      const T low = T(j) * unit_, high = T(j + 1) * unit_;
      Index first = endless, end = -endless;
      bool touched = false;
      const auto meet = [&](const T& n, const T& d, bool attained) {  // x = n/d
        touched = true;
        const T by = d * unit_;
        const T floor = floor_div(n, by);
        const Index from = index_of(floor);
        first = std::min(first, from);
        if (has(nearest_high_sides) && floor * by == n) first = std::min(first, from - 1);
        const bool on_line = floor * by == n;
        if (has(nearest_high_corner) && on_line && attained && has_low && polygon.size() > 2)
          corner_hit(n, d, low, polygon, from, first);
        end = std::max(end, attained || !on_line ? from : from - 1);
      };
      if (polygon.size() == 1) meet(polygon[0].x, T(1), true);
      for (std::size_t k = 0; k < polygon.size() && polygon.size() > 1; ++k) {
        const Point<T>&p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
        const T dx = q.x - p.x, dy = q.y - p.y;
        const bool p_in = (!has_low || p.y >= low) && (!has_high || p.y <= high);
        if (p_in) meet(p.x, T(1), !has_high || p.y < high);
        if (dy == 0) continue;
        const auto across = [&](const T& line, bool attained) {
          if ((p.y < line) == (q.y < line) && p.y != line && q.y != line) return;
          const T d = dy < 0 ? T(-dy) : dy;
          meet(p.x * d + (line - p.y) * (dy < 0 ? T(-dx) : dx), d, attained);
        };
        if (has_low) across(low, true);
        if (has_high) across(high, false);
      }
      if (!touched) continue;
      if (has(nearest_low_sides) && has_low && j == box.bottom && j > box.top && polygon.size() > 1) {
        // the row met by its low side alone
        T most = polygon[0].y;
        for (const auto& p : polygon) most = std::max(most, p.y);
        if (most == low) continue;
      }
      first = std::clamp(first, columns_.low, columns_.high);
      end = std::clamp(end, columns_.low, columns_.high);
      end = std::min(end, along_all_ == endless ? end : first + along_all_ - 1);
      spend(end - first);
      for (Index i = first; i <= end; ++i) {
        seen |= f.signs[texel(i, j)];
        if (settled(seen, aim)) return seen;
      }
    }
    return seen;
  }

  /// A fault's: counts the texel whose high corner a vertex of the polygon is.
  void corner_hit(const T& n, const T& d, const T& low, const std::vector<Point<T>>& polygon, Index from,
                  Index& first) const {
    if (d != 1) return;
    for (const auto& p : polygon)
      if (p.x == n && p.y == low) first = std::min(first, from - 1);
  }

  // ----------------------------------------------------------------------------------------- bilinear

  unsigned signs_of_point(const Node& node, const Field& f) const {
    const Point<T> p = vertex(node.corners[0]);
    const std::vector<Point<T>> one{p};
    return nearest_ ? nearest_signs(one, f, Aim::both_sides)
                    : exact_signs(one, f, Aim::both_sides, true, node);
  }

  unsigned bilinear_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim,
                          const Node& node) const {
    bool inside = !has(edges_only);
    if (has(clockwise_hollow) && clockwise()) inside = false;
    if (has(edges_only_when_small)) {
      const Box b = cells_of(polygon);
      if (b.right - b.left < 2 && b.bottom - b.top < 2) inside = false;
    }
    const bool line = clockwise_sign() == 0;
    if ((has(line_is_its_corners) && line) || (has(sliver_is_its_corners) && is_sliver()) ||
        has(corners_only)) {
      unsigned seen = 0;
      for (const Point<T>& p : polygon) seen |= exact_signs({p}, f, aim, true, node);
      return seen;
    }
    if (inside) {
      const unsigned all = texel_signs(polygon, f);
      if ((all & negative) == 0 && aim != Aim::any_positive) return all;
      if (all == negative) return all;
      if ((all & positive) == 0 && aim == Aim::any_positive) return all;
    }
    bool unsure = false;
    const unsigned seen = rough_signs(polygon, f, aim, inside, unsure, node);
    if (settled(seen, aim) || !unsure) return seen;
    if (has(double_decides)) return seen;
    return exact_signs(polygon, f, aim, inside, node);
  }

  int clockwise_sign() const { return sign(T(along_u_[0] * along_v_[1] - along_u_[1] * along_v_[0])); }
  bool clockwise() const { return clockwise_sign() < 0; }
  bool is_sliver() const {
    const double ux = real(along_u_[0]), uy = real(along_u_[1]), vx = real(along_v_[0]),
                 vy = real(along_v_[1]);
    return std::abs(ux * vy - uy * vx) * 1e5 < std::max(ux * ux + uy * uy, vx * vx + vy * vy);
  }

  /// The signs of all texels of all cells about a polygon.
  unsigned texel_signs(const std::vector<Point<T>>& polygon, const Field& f) const {
    const Box b = cells_of(polygon);
    const Index right = along_all_ == endless ? b.right + 1 : std::min(b.right + 1, b.left + along_all_ - 1);
    const Index bottom = down_all_ == endless ? b.bottom + 1 : std::min(b.bottom + 1, b.top + down_all_ - 1);
    unsigned seen = 0;
    for (Index j = b.top; j <= bottom; ++j)
      for (Index i = b.left; i <= right; ++i) {
        seen |= f.signs[texel(i, j)];
        if ((seen & negative) != 0 && (seen & positive) != 0) return seen;
      }
    return seen;
  }

  /// Signs from binary64.  All of it is off by a few dozen roundings of numbers that are at most the extent.
  unsigned rough_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim, bool inside,
                       bool& unsure, const Node& node) const {
    std::vector<Point<double>> p;
    double extent = 1;
    for (const auto& q : polygon) {
      p.push_back({real(q.x) / unit_real_, real(q.y) / unit_real_});
      extent = std::max({extent, std::abs(p.back().x), std::abs(p.back().y)});
    }
    double near = extent * 0x1p-40;
    if (has(double_decides)) near = 0;
    unsigned seen = 0;
    const auto meet = [&](double value) {
      if (value > near)
        seen |= positive;
      else if (value < -near)
        seen |= negative;
      else if (has(double_decides))
        seen |= zero;
      else
        unsure = true;
    };
    const Box box = cells_of(polygon);
    spend(box.bottom - box.top);
    Index last = box.bottom;
    if (has(rows_up_to_256)) last = std::min(last, box.top + 255);
    if (has(rows_up_to_16)) last = std::min(last, box.top + 15);
    for (std::size_t e = 0; e < p.size(); ++e) {
      const Point<double>&a = p[e], &b = p[(e + 1) % p.size()];
      const double dx = b.x - a.x, dy = b.y - a.y;
      for (Index j = box.top; j <= last; ++j) {
        double t0 = 0, t1 = 1;
        clip(a.y, dy, j > rows_.low, static_cast<double>(j), j < rows_.high, static_cast<double>(j + 1), t0,
             t1);
        if (t0 > t1) continue;
        const double xa = a.x + t0 * dx, xb = a.x + t1 * dx;
        const auto cell = [&](double x) {
          return std::clamp(static_cast<Index>(std::floor(x)), columns_.low, columns_.high);
        };
        const Index from = cell(std::min(xa, xb)), until = cell(std::max(xa, xb));
        spend(until - from);
        for (Index i = from; i <= until; ++i) {
          double s0 = t0, s1 = t1;
          clip(a.x, dx, i > columns_.low, static_cast<double>(i), i < columns_.high,
               static_cast<double>(i + 1), s0, s1);
          if (s0 > s1) continue;
          rough_segment(f, i, j,
                        {a.x + s0 * dx - static_cast<double>(i), a.y + s0 * dy - static_cast<double>(j)},
                        {a.x + s1 * dx - static_cast<double>(i), a.y + s1 * dy - static_cast<double>(j)}, e,
                        meet, node);
          if (settled(seen, aim)) return seen;
        }
      }
    }
    if (has(saddle)) saddles(box, f, meet);
    if (!inside || p.size() < 3) return seen;
    for (Index j = std::max(box.top, rows_.low + 1); j <= last && j <= rows_.high; ++j) {
      const auto y = static_cast<double>(j);
      double left = 1e300, right = -1e300;
      for (std::size_t e = 0; e < p.size(); ++e) {
        const Point<double>&a = p[e], &b = p[(e + 1) % p.size()];
        if (std::min(a.y, b.y) > y || std::max(a.y, b.y) < y || a.y == b.y) continue;
        const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
        left = std::min(left, x);
        right = std::max(right, x);
      }
      if (left > right) continue;
      Index from = std::clamp(index_of(static_cast<Wide>(std::ceil(left))),
                              std::max(columns_.low + 1, -endless), columns_.high);
      Index until = std::clamp(index_of(static_cast<Wide>(std::floor(right))),
                               std::max(columns_.low, -endless), columns_.high);
      if (along_all_ != endless) until = std::min(until, from + along_all_ - 1);
      spend(until - from);
      for (Index i = from; i <= until; ++i) {
        meet(f.approximate[texel(i, j)]);
        if (settled(seen, aim)) return seen;
      }
    }
    return seen;
  }

  template <class Meet>
  void saddles(const Box& box, const Field& f, const Meet& meet) const {
    if (box.right - box.left > 8 || box.bottom - box.top > 8) return;
    for (Index j = box.top; j <= box.bottom; ++j)
      for (Index i = box.left; i <= box.right; ++i) {
        const double a = f.approximate[texel(i, j)], b = f.approximate[texel(i + 1, j)] - a,
                     c = f.approximate[texel(i, j + 1)] - a;
        const double d = f.approximate[texel(i + 1, j + 1)] - a - b - c;
        if (d == 0) continue;
        const double x = -c / d, y = -b / d;
        if (x > 0 && x < 1 && y > 0 && y < 1) meet(a + b * x + c * y + d * x * y);
      }
  }

  /// Limits t to where low <= at + t by <= high.
  static void clip(double at, double by, bool has_low, double low, bool has_high, double high, double& t0,
                   double& t1) {
    if (by == 0) {
      if ((has_low && at < low) || (has_high && at > high)) t1 = -1;
      return;
    }
    if (by > 0 ? has_low : has_high) t0 = std::max(t0, ((by > 0 ? low : high) - at) / by);
    if (by > 0 ? has_high : has_low) t1 = std::min(t1, ((by > 0 ? high : low) - at) / by);
  }

  bool stands_still_counts(std::size_t edge, bool least) const {
    if (has(no_critical_point) || (has(no_critical_second_edge) && edge == 1)) return false;
    if (has(no_critical_point_at_6) && case_.level >= 6) return false;
    return !(least ? has(no_critical_minimum) : has(no_critical_maximum));
  }

  template <class Meet>
  void rough_segment(const Field& f, Index i, Index j, Point<double> p, Point<double> q, std::size_t edge,
                     const Meet& meet, const Node&) const {
    const auto& g = f.approximate;
    const double a = g[texel(i, j)], b = g[texel(i + 1, j)] - a, c = g[texel(i, j + 1)] - a,
                 d = g[texel(i + 1, j + 1)] - a - b - c;
    const auto at = [&](double x, double y) { return a + b * x + c * y + d * x * y; };
    const double dx = q.x - p.x, dy = q.y - p.y;
    const bool crossing = p.y == 0 || q.y == 1;
    if (!(has(no_cell_crossings) && crossing)) {
      meet(at(p.x, p.y));
      meet(at(q.x, q.y));
    }
    const double square = d * dx * dy, slope = b * dx + c * dy + d * (p.x * dy + p.y * dx);
    if (square == 0 || !stands_still_counts(edge, square > 0)) return;
    const double t = -slope / (2 * square);
    if (t > 0 && t < 1) meet(at(p.x, p.y) + t * (slope + t * square));
  }

  /// The same in whole numbers, as wide as it takes.
  unsigned exact_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim, bool inside,
                       const Node& node) const {
    if (has(tolerance_1e_6) || has(tolerance_1e_12) ||
        (has(tolerance_1e_12_blend) && case_.alpha_mode == MMVERIFY_BLEND)) {
      // near enough is good enough: only what binary64 is sure of counts
      bool unsure = false;
      const unsigned seen = tolerant_signs(polygon, f, inside, unsure, node);
      return seen != 0 ? seen : unsigned{positive};
    }
    if (std::is_same_v<T, Wide> && f.fits && 2 * f.size_bits + 4 * place_bits_ + 14 <= 126)
      return whole_signs<Wide>(polygon, f, aim, inside);
    return whole_signs<Big>(polygon, f, aim, inside);
  }

  unsigned tolerant_signs(const std::vector<Point<T>>& polygon, const Field& f, bool inside, bool& unsure,
                          const Node& node) const {
    return rough_signs(polygon, f, Aim::both_sides, inside, unsure, node);
  }

  template <class E>
  struct Fraction {
    E n, d;  // d > 0
  };
  template <class E>
  static bool less(const Fraction<E>& a, const Fraction<E>& b) {
    return a.n * b.d < b.n * a.d;
  }
  template <class E>
  static void clip(const E& at, const E& by, bool has_low, const E& low, bool has_high, const E& high,
                   Fraction<E>& t0, Fraction<E>& t1) {
    if (by == 0) {
      if ((has_low && at < low) || (has_high && at > high)) t1 = {E(-1), E(1)};
      return;
    }
    const bool up = by > 0;
    const auto where = [&](const E& line) {
      return up ? Fraction<E>{line - at, by} : Fraction<E>{at - line, -by};
    };
    if (up ? has_low : has_high) {
      const auto t = where(up ? low : high);
      if (less(t0, t)) t0 = t;
    }
    if (up ? has_high : has_low) {
      const auto t = where(up ? high : low);
      if (less(t, t1)) t1 = t;
    }
  }

  template <class E>
  unsigned whole_signs(const std::vector<Point<T>>& polygon, const Field& f, Aim aim, bool inside) const {
    std::vector<Point<E>> p;
    for (const auto& q : polygon) p.push_back({to<E>(q.x), to<E>(q.y)});
    const E unit = to<E>(unit_);
    const Box box = cells_of(polygon);
    spend(box.bottom - box.top);
    Index last = box.bottom;
    if (has(rows_up_to_256)) last = std::min(last, box.top + 255);
    if (has(rows_up_to_16)) last = std::min(last, box.top + 15);
    unsigned seen = 0;
    for (std::size_t e = 0; e < p.size(); ++e) {
      const Point<E>&a = p[e], &b = p[(e + 1) % p.size()];
      const E dx = b.x - a.x, dy = b.y - a.y;
      for (Index j = box.top; j <= last; ++j) {
        Fraction<E> t0{E(0), E(1)}, t1{E(1), E(1)};
        clip<E>(a.y, dy, j > rows_.low, E(j) * unit, j < rows_.high, E(j + 1) * unit, t0, t1);
        if (less(t1, t0)) continue;
        const auto cell = [&](const Fraction<E>& t) {
          return std::clamp(index_of(floor_div(E(a.x * t.d + t.n * dx), E(t.d * unit))), columns_.low,
                            columns_.high);
        };
        const Index one = cell(t0), other = cell(t1);
        spend(std::abs(one - other));
        for (Index i = std::min(one, other); i <= std::max(one, other); ++i) {
          Fraction<E> s0 = t0, s1 = t1;
          clip<E>(a.x, dx, i > columns_.low, E(i) * unit, i < columns_.high, E(i + 1) * unit, s0, s1);
          if (less(s1, s0)) continue;
          seen |= whole_segment<E>(f, i, j, {a.x - E(i) * unit, a.y - E(j) * unit}, dx, dy, s0, s1, e);
          if (settled(seen, aim)) return seen;
        }
      }
    }
    if (!inside || p.size() < 3) return seen;
    for (Index j = std::max(box.top, rows_.low + 1); j <= last && j <= rows_.high; ++j) {
      const E y = E(j) * unit;
      std::optional<E> left, right;
      for (std::size_t e = 0; e < p.size(); ++e) {
        const Point<E>&a = p[e], &b = p[(e + 1) % p.size()];
        if (a.y == b.y || std::min(a.y, b.y) > y || std::max(a.y, b.y) < y) continue;
        const E d = b.y > a.y ? E(b.y - a.y) : E(a.y - b.y), dx = b.y > a.y ? E(b.x - a.x) : E(a.x - b.x);
        const E n = a.x * d + (y - a.y) * dx, by = d * unit;
        const E up = ceil_div(n, by), down = floor_div(n, by);
        if (!left || up < *left) left = up;
        if (!right || down > *right) right = down;
      }
      if (!left || *left > *right) continue;
      const Index from = std::max(index_of(*left), columns_.low + 1);
      Index until = std::min(index_of(*right), columns_.high);
      if (along_all_ != endless) until = std::min(until, from + along_all_ - 1);
      spend(until - from);
      for (Index i = from; i <= until; ++i) {
        seen |= f.signs[texel(i, j)];
        if (settled(seen, aim)) return seen;
      }
    }
    return seen;
  }

  /// The signs of a + bx + cy + dxy along (p.x + t dx, p.y + t dy), t0 <= t <= t1, all in units of the cell.
  template <class E>
  unsigned whole_segment(const Field& f, Index i, Index j, const Point<E>& p, const E& dx, const E& dy,
                         const Fraction<E>& t0, const Fraction<E>& t1, std::size_t edge) const {
    const E unit = to<E>(unit_);
    const E a = f.value<E>(texel(i, j)), b = f.value<E>(texel(i + 1, j)) - a,
            c = f.value<E>(texel(i, j + 1)) - a, d = f.value<E>(texel(i + 1, j + 1)) - a - b - c;
    const E square = d * dx * dy;
    const E slope = unit * (b * dx + c * dy) + d * (p.x * dy + p.y * dx);
    const E constant = unit * (a * unit + b * p.x + c * p.y) + d * p.x * p.y;
    const auto at = [&](const Fraction<E>& t) {
      return sign_bit(sign(E((square * t.n + slope * t.d) * t.n + constant * t.d * t.d)));
    };
    unsigned seen = 0;
    const bool crossing = has(no_cell_crossings) && (t0.n != 0 || t1.n != t1.d);
    if (!crossing) seen = at(t0) | at(t1);
    if (square == 0 || !stands_still_counts(edge, square > 0)) return seen;
    const bool up = square > 0;
    const Fraction<E> still{up ? E(-slope) : slope, up ? E(2 * square) : E(-2 * square)};
    if (!less(t0, still) || !less(still, t1)) return seen;
    const int above = sign(E(4 * square * constant - slope * slope));
    return seen | sign_bit(up ? above : -above);
  }

  const mmverify_bake_case_t& case_;
  const Mip& mip_;
  [[maybe_unused]] unsigned number_;
  bool nearest_;
  T start_[2], along_u_[2], along_v_[2], margin_[2], unit_;
  Index origin_[2];
  double unit_real_;
  int place_bits_;
  unsigned wrap_u_, wrap_v_;
  Range columns_, rows_;
  Index along_all_, down_all_;
};

// ------------------------------------------------------------------------------------------------- baking

constexpr unsigned transparent = 0, opaque = 1, unknown = 2;

template <class T>
class Baker {
 public:
  Baker(const mmverify_bake_case_t& c, const std::vector<Mip>& mips, std::uint8_t* map)
      : case_(c), mips_(mips), map_(map) {
    for (unsigned k = 0; k < mips.size(); ++k) {
      const bool nearest = c.filter == MMVERIFY_NEAREST || (has(mips_nearest) && k > 0);
      sampled_.emplace_back(c, mips[k], k, nearest);
    }
    std::size_t m = 0;
    if (has(centroid_of_second_mip)) m = std::min<std::size_t>(1, mips.size() - 1);
    if (has(centroid_of_last_mip) && mips.size() >= 3) m = mips.size() - 1;
    centre_mip_ = m;
    is_point_ = std::all_of(c.uv, c.uv + 6, [&](const float& x) { return x == c.uv[(&x - c.uv) % 2]; });
  }

  void bake() {
    const std::uint32_t n = 1u << case_.level;
    descend({{{{0, 0}, {n, 0}, {0, n}}}}, 0, 0);
    finish();
  }

 private:
  /// O, T or unknown: of the whole closed node, in each mip.
  unsigned state(const Node& node) const {
    bool all_O = true, all_T = true;
    for (std::size_t k = 0; k < sampled_.size(); ++k) {
      if (k > 0 && has(mips_ignored)) break;
      if (k >= 2 && has(third_mip_ignored)) break;
      if (k >= 3 && has(fourth_mip_ignored)) break;
      if (k >= 2 && k + 1 == sampled_.size() && has(last_mip_ignored)) break;
      if (k == 1 && sampled_.size() >= 3 && has(middle_mip_ignored)) continue;
      if (k > 0 && mips_[k - 1].count == 1 && has(mip_of_size_1_again)) break;
      const auto& fields = mips_[k].fields;
      if (case_.alpha_mode == MMVERIFY_MASK) {
        unsigned s = sampled_[k].signs(node, fields[0], Aim::both_sides);
        if (has(mask_greater)) {
          all_T = all_T && (s & (zero | positive)) == 0;
          if (s != positive && (s & negative) == 0) s = strictly(node, k);
          all_O = all_O && (s & (negative | zero)) == 0;
          continue;
        }
        if (has(mask_T_at_cutoff) && s != negative) {
          all_O = all_O && (s & negative) == 0;
          all_T = all_T && (sampled_[k].signs(node, fields[0], Aim::any_positive) & positive) == 0 &&
                  (s & negative) != 0;
          continue;
        }
        all_O = all_O && (s & negative) == 0;
        if (!(k >= 2 && has(mips_T_by_first))) all_T = all_T && (s & (zero | positive)) == 0;
      } else {
        unsigned o = sampled_[k].signs(node, fields[0], Aim::any_negative);
        if (has(blend_greater) && o == zero) o = negative;
        all_O = all_O && (o & negative) == 0;
        if (all_T && !(k >= 2 && has(mips_T_by_first))) {
          const unsigned t = sampled_[k].signs(node, fields[1], Aim::any_positive);
          all_T = (t & positive) == 0 && !(has(blend_T_never) && t == zero);
        }
      }
      if (!all_O && !all_T) break;
    }
    return all_O ? opaque : all_T ? transparent : unknown;
  }

  unsigned strictly(const Node& node, std::size_t k) const {
    // any zero left? ask corners and the centroid
    unsigned s = 0;
    for (std::size_t c = 0; c < 3; ++c) s |= sign_bit(sampled_[k].corner_sign(node, mips_[k].fields[0], c));
    return s | sign_bit(sampled_[k].centroid_sign(node, mips_[k].fields[0]));
  }

  bool opaque_at_centroid(const Node& node) const {
    const auto& fields = mips_[centre_mip_].fields;
    const bool mask = case_.alpha_mode == MMVERIFY_MASK;
    const int s = sampled_[centre_mip_].centroid_sign(node, fields[mask ? 0 : 2]);
    if (has(centroid_greater) && mask) return s > 0;
    if (has(centroid_greater_blend) && !mask) return s > 0;
    return s >= 0;
  }

  static std::array<Node, 4> children(const Node& n, bool odd) {
    const auto middle = [](const std::array<std::uint32_t, 2>& a, const std::array<std::uint32_t, 2>& b) {
      return std::array<std::uint32_t, 2>{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
    };
    const auto &a = n.corners[0], &b = n.corners[1], &c = n.corners[2];
    const auto ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    // the order of the index: child 0 at the first corner, 1 in the middle, 2 and 3 at the others
    std::array<Node, 4> out{Node{{a, ab, ca}}, Node{{ca, bc, ab}}, Node{{ab, b, bc}}, Node{{bc, ca, c}}};
    if (odd) {
      out[0] = Node{{a, ca, ab}};
      out[3] = Node{{ca, bc, c}};
    }
    return out;
  }

  void descend(const Node& node, unsigned depth, std::uint64_t index) {
    unsigned s = state(node);
    const unsigned level = case_.level;
    if (level == 0 && has(level_0_centre)) s = opaque_at_centroid(node) ? opaque : transparent;
    const std::uint64_t count = std::uint64_t{1} << (2 * (level - depth));
    if (s != unknown) {
      if (s == opaque && has(unknown_O)) s = 3;
      for (std::uint64_t k = 0; k < count; ++k) put(index * count + k, s);
      return;
    }
    if ((has(point_is_T) || (has(points_of_level_4_are_T) && level >= 4)) && is_point_) {
      for (std::uint64_t k = 0; k < count; ++k) put(index * count + k, has(point_is_T) ? 2 : 0);
      return;
    }
    const bool stops = depth == level || (has(coarse_at_5) && depth == 4) ||
                       (has(coarse_at_7) && depth == 6) || (has(coarse_at_9) && depth == 8);
    if (stops) {
      const unsigned lean = opaque_at_centroid(node) ? 3 : 2;
      for (std::uint64_t k = 0; k < count; ++k) put(index * count + k, lean);
      return;
    }
    const bool by_parent = (has(centroid_of_parent_at_7) && level >= 7) ||
                           (has(two_state_parent_at_5) && level >= 5 && case_.format == MMVERIFY_2_STATE);
    if (by_parent && depth + 1 == level) {
      const unsigned lean = opaque_at_centroid(node) ? 3 : 2;
      const auto kids = children(node, false);
      for (std::size_t k = 0; k < 4; ++k) {
        const unsigned own = state(kids[k]);
        put(index * 4 + k, own == unknown ? lean : own);
      }
      return;
    }
    const bool odd = (has(curve_from_5) && depth + 1 >= 4) || (has(curve_from_7) && depth + 1 >= 6);
    const auto kids = children(node, odd);
    for (std::size_t k = 0; k < 4; ++k) descend(kids[k], depth + 1, index * 4 + k);
  }

  unsigned get(std::uint64_t k) const {
    if (case_.format == MMVERIFY_2_STATE) return (map_[k / 8] >> (k % 8)) & 1u;
    return (map_[k / 4] >> (2 * (k % 4))) & 3u;
  }

  void put(std::uint64_t k, unsigned s) {
    const unsigned level = case_.level;
    const std::uint64_t last = (std::uint64_t{1} << (2 * level)) - 1;
    if (s >= 2) {
      const bool made_known = (has(known_at_6) && level >= 6) || (has(known_at_7) && level >= 7) ||
                              (has(known_at_9) && level >= 9) || (has(known_at_12) && level == 12) ||
                              (has(last_is_known) && level >= 4 && k == last) ||
                              (has(one_is_known) && level == 5 && k == 777);
      if (made_known) s -= 2;
      const std::uint32_t w = case_.width;
      if ((has(known_when_wide_32) && w > 32) || (has(known_when_wide_64) && w > 64) ||
          (has(known_when_wide_256) && w > 256))
        s = opaque;
      if (has(known_when_high_32) && case_.height > 32) s = transparent;
    } else {
      const bool made_unknown = (has(last_is_unknown) && level >= 4 && k == last) ||
                                (has(one_is_unknown) && level == 5 && k == 777) ||
                                (has(unknown_when_far) && is_far(case_)) ||
                                (has(unknown_when_wide) && case_.width > 32) ||
                                (has(unknown_with_mips) && case_.mips > 2) || has(unknown_throughout);
      if (made_unknown) s += 2;
    }
    if (has(map_in_12_bits) && k >= 4096) s = known_before(k - 4096);
    if (has(map_in_16_bits) && k >= 65536) s = known_before(k - 65536);
    if (case_.format == MMVERIFY_2_STATE) {
      unsigned bit = s & 1u;
      if (s >= 2 && (has(two_state_unknown_T) || (has(two_state_at_8) && level >= 8))) bit = 0;
      if (s >= 2 && has(two_state_level_0) && level == 0) bit = 1;
      if (has(two_state_last) && level % 2 == 1 && k == last) bit = 0;
      map_[k / 8] = static_cast<std::uint8_t>((map_[k / 8] & ~(1u << (k % 8))) | (bit << (k % 8)));
    } else {
      const auto shift = static_cast<unsigned>(2 * (k % 4));
      map_[k / 4] = static_cast<std::uint8_t>((map_[k / 4] & ~(3u << shift)) | (s << shift));
    }
  }

  unsigned known_before(std::uint64_t k) const { return get(k); }

  void finish() {
    if (case_.level == 0 && has(level_0_is_level_1)) {
      mmverify_bake_case_t finer = case_;
      finer.level = 1;
      finer.format = MMVERIFY_4_STATE;
      std::uint8_t four = 0;
      Baker(finer, mips_, &four).bake();
      map_[0] = case_.format == MMVERIFY_2_STATE ? four & 1u : four & 3u;
    }
    if (case_.format == MMVERIFY_2_STATE && case_.level == 0 && has(two_state_padding)) map_[0] |= 0xfeu;
    if (case_.format == MMVERIFY_2_STATE && case_.level == 1 && has(two_state_padding_of_unknown) &&
        (map_[0] & 8u) != 0)
      map_[0] |= 0xf0u;
    if (case_.format == MMVERIFY_4_STATE && case_.level == 0 && has(four_state_padding)) map_[0] |= 0xfcu;
  }

  const mmverify_bake_case_t& case_;
  const std::vector<Mip>& mips_;
  std::uint8_t* map_;
  std::vector<Sampled<T>> sampled_;
  std::size_t centre_mip_ = 0;
  bool is_point_ = false;
};

bool known_case(const mmverify_bake_case_t& c) {
  return c.size >= sizeof(mmverify_bake_case_t) && c.size == sizeof(mmverify_bake_case_t) && c.level <= 12 &&
         (c.format == MMVERIFY_2_STATE || c.format == MMVERIFY_4_STATE) && c.width > 0 && c.height > 0 &&
         c.mips > 0 && c.texel >= MMVERIFY_UNORM8 && c.texel <= MMVERIFY_FLOAT32 &&
         c.filter <= MMVERIFY_NEAREST && c.wrap_u <= MMVERIFY_MIRROR_CLAMP_TO_EDGE &&
         c.wrap_v <= MMVERIFY_MIRROR_CLAMP_TO_EDGE && c.alpha_mode <= MMVERIFY_BLEND;
}

std::vector<Mip> mips_of(const mmverify_bake_case_t& c) {
  std::vector<Mip> mips;
  const auto* at = static_cast<const unsigned char*>(c.texels);
  const auto* const begin = at;
  std::size_t all = 0;
  for (unsigned k = 0; k < c.mips; ++k)
    all += static_cast<std::size_t>(std::max(1u, k < 32 ? c.width >> k : 0u)) *
           std::max(1u, k < 32 ? c.height >> k : 0u);
  const auto* const end = begin + all * bytes_of(c);
  Index w = c.width, h = c.height;
  for (unsigned k = 0; k < c.mips; ++k) {
    Mip m;
    m.width = w;
    m.height = h;
    m.count = static_cast<std::size_t>(w * h);
    if (at + m.count * bytes_of(c) > end) at = end - m.count * bytes_of(c);  // only with a fault
    if (at < begin) {
      m.width = m.height = 1;
      m.count = 1;
      at = begin;
    }
    const Stored s = read_texels(c, at, m.count, k > 0);
    const auto thresholds = thresholds_of(c, s.full);
    for (std::size_t t = 0; t < thresholds.size(); ++t)
      m.fields.push_back(field_of(c, s, thresholds[t], t == 2));
    std::size_t step = m.count;
    if (has(mip_offset_by_quarters) && k > 0) step = std::max<std::size_t>(1, mips.back().count / 4);
    at += step * bytes_of(c);
    mips.push_back(std::move(m));
    w = next_size(w, mip_rounded_up);
    h = next_size(h, mip_rounded_up);
    if (has(mip_halved_twice) && k == 1) {
      w = (mips.back().width + 1) / 2;
      h = (mips.back().height + 1) / 2;
    }
  }
  return mips;
}

int bake(const mmverify_bake_case_t* what, std::uint8_t* map) {
  try {
    const mmverify_bake_case_t& c = *what;
    if (!known_case(c)) return 0;
    const auto mips = mips_of(c);
    const std::uint64_t states = std::uint64_t{1} << (2 * c.level);
    std::memset(map, 0, (states * c.format + 7) / 8);
    int widest = 0;
    for (unsigned k = 0; k < mips.size(); ++k) {
      const Placed p = place(c, mips[k].width, mips[k].height, k, c.filter == MMVERIFY_NEAREST);
      widest = std::max(widest, p.size_bits);
    }
    if (2 * widest + 16 <= 126)
      Baker<Wide>(c, mips, map).bake();
    else
      Baker<Big>(c, mips, map).bake();
    return 1;
  } catch (const Declined&) {
    return 0;
  }
}

const mmverify_subject_t subject = [] {
  mmverify_subject_t s{};
  s.abi = MMVERIFY_SUBJECT_ABI;
  s.size = sizeof(mmverify_subject_t);
  s.name = "foreign-bake";
  s.max_level = 12;
  s.flags = MMVERIFY_BAKE_CENTROID;
  s.bake = bake;
  return s;
}();

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) { return fault ? &subject : nullptr; }
