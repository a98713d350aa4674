// A baker that declares what it supports, chosen when it is linked: this library's, told of each case by the C face,
// by the declared rules.  What is wrong with some of them their names say.
#include <cstdint>
#include <cstring>
#include <vector>

#include "impl/mmverify.h"
#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

namespace {

/// Alpha above the cutoff is 1 - alpha below 1 - cutoff: what the library calls transparent there is opaque here.
/// Domain: texels of 8 bits, a cutoff of at most 1, no factors.
bool baked(const mmverify_bake_case_t& c, bool turned, std::vector<std::uint8_t>& map) {
  const auto* texels = static_cast<const std::uint8_t*>(c.texels);
  std::vector<std::uint8_t> alpha(texels, texels + std::size_t{c.width} * c.height);
  if (turned)
    for (std::uint8_t& a : alpha) a = static_cast<std::uint8_t>(255 - a);
  const mmverify_texture mip{alpha.data(), c.width, c.height};
  mmverify_sampling how{};
  how.texel = c.texel;
  how.filter = c.filter;
  how.wrap_u = c.wrap_u;
  how.wrap_v = c.wrap_v;
  how.factor = how.vertex_factor = 1;
  how.cutoff_numerator = turned ? c.cutoff_denominator - c.cutoff_numerator : c.cutoff_numerator;
  how.cutoff_denominator = c.cutoff_denominator;
  if (wrong_is(
          "cutoff_half_a_slack_off")) {  // 2^-9 more: within the slack of weights of 8 bits, if all is sampled
    how.cutoff_numerator = 512 / 2 + 1;
    how.cutoff_denominator = 512;
  }
  mmverify_baker* const baker = mmverify_baker_new(&mip, 1, &how);
  if (baker == nullptr) return false;
  const bool done = mmverify_bake(baker, c.uv, c.level, map.data()) != 0;
  mmverify_baker_free(baker);
  return done;
}

/// Declines every case that the declaration does not cover.
bool supported(const mmverify_bake_case_t& c) {
  const bool clamped = c.wrap_u == MMVERIFY_CLAMP_TO_EDGE && c.wrap_v == MMVERIFY_CLAMP_TO_EDGE;
  for (const float x : c.uv)
    if (!(x >= 0 && x <= 1)) return false;
  return clamped && c.mips == 1 && c.texel == MMVERIFY_UNORM8 && c.margin == 0 && c.factor == 1 &&
         c.vertex_factor == 1 && c.alpha_mode == MMVERIFY_MASK && c.filter == MMVERIFY_BILINEAR &&
         c.cutoff_numerator <= c.cutoff_denominator &&
         (c.cutoff_denominator & (c.cutoff_denominator - 1)) == 0;
}

int bake(const mmverify_bake_case_t* what, std::uint8_t* out) {
  const mmverify_bake_case_t& c = *what;
  if (!supported(c)) return 0;
  std::vector<std::uint8_t> map(((std::size_t{1} << 2 * c.level) + 3) / 4);
  const bool turned = !wrong_is("meets_the_cutoff") && !wrong_is("cutoff_half_a_slack_off");
  if (!baked(c, turned, map)) return 0;
  std::memset(out, 0, ((std::size_t{c.format} << 2 * c.level) + 7) / 8);
  for (std::size_t k = 0; k < std::size_t{1} << 2 * c.level; ++k) {
    unsigned state = map[k / 4] >> 2 * (k % 4) & 3u;
    if (turned) state ^= 1;
    if (wrong_is("all_unknowns_opaque") && state == 2) state = 3;
    if (wrong_is("one_unknown_transparent") && state == 3 && k % 7 == 1) state = 2;
    if (c.format == MMVERIFY_2_STATE) state &= 1;
    out[k * c.format / 8] = static_cast<std::uint8_t>(out[k * c.format / 8] | state << k * c.format % 8);
  }
  return 1;
}

mmverify_bake_support_t support() {
  mmverify_bake_support_t s{};
  s.size = sizeof s;
  s.texels = 1u << MMVERIFY_UNORM8;
  s.filters = 1u << MMVERIFY_BILINEAR;
  s.wraps = 1u << MMVERIFY_CLAMP_TO_EDGE;
  s.alpha_modes = 1u << MMVERIFY_MASK;
  s.max_mips = 1;
  s.restrictions = MMVERIFY_BAKE_NO_FACTORS | MMVERIFY_BAKE_NO_MARGIN | MMVERIFY_BAKE_FLOAT_CUTOFFS;
  s.opaque = MMVERIFY_OPAQUE_ABOVE_CUTOFF;
  s.uv_min = 0;
  s.uv_max = 1;
  s.unknown = MMVERIFY_UNKNOWN_BY_CENTROID;
  if (wrong_is("all_unknowns_opaque") || wrong_is("one_unknown_transparent"))
    s.unknown = MMVERIFY_UNKNOWN_OPAQUE;
  if (wrong_is("cutoff_half_a_slack_off")) {
    s.opaque = MMVERIFY_OPAQUE_FROM_CUTOFF;
    s.fixed_cutoff = 0.5f;
    s.weight_bits = 8;
    s.unknown = MMVERIFY_UNKNOWN_ANY;
  }
  if (wrong_is("upside_down")) s.uv_min = 2;
  return s;
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_bake_support_t declared = support();
  static mmverify_subject_t subject{};
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.name = "a baker that says what it supports";
  subject.bake = bake;
  if (!wrong_is("says_nothing")) subject.bake_support = &declared;
  return &subject;
}
