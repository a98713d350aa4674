// This project's own baker, by its interface in C, as a subject: the baseline of the others' times, through
// the same interface.
#include <mmverify/mmverify.h>

#include "examples/adapters/subject.hpp"

static mmverify_baker* baker_of(const mmverify_bake_case_t& c) {
  static thread_local std::vector<uint8_t> texels;
  static thread_local std::vector<uint32_t> asked;
  static thread_local mmverify_baker* made = nullptr;
  const std::vector<uint32_t> now = {c.filter,     c.wrap_u,           c.wrap_v,
                                     c.alpha_mode, c.cutoff_numerator, c.cutoff_denominator};
  if (same_texture_as_before(c) && now == asked) return made;
  mmverify_baker_free(made);
  texels.assign(static_cast<const uint8_t*>(c.texels), each_mip(c, [](auto...) {}));
  std::vector<mmverify_texture> mips;
  size_t at = 0;
  each_mip(c, [&](uint32_t w, uint32_t h, auto) {
    mips.push_back({texels.data() + at, w, h});
    at += size_t{w} * h;
  });
  mmverify_sampling how = {};
  how.texel = MMVERIFY_TEXEL_UNORM8, how.filter = c.filter, how.wrap_u = c.wrap_u, how.wrap_v = c.wrap_v;
  how.factor = how.vertex_factor = 1, how.blend = c.alpha_mode;
  how.cutoff_numerator = c.cutoff_numerator, how.cutoff_denominator = c.cutoff_denominator;
  asked = now;
  return made = mmverify_baker_new(mips.data(), mips.size(), &how);
}

static int bake(const mmverify_bake_case_t* c, uint8_t* map) {
  const mmverify_baker* const baker = baker_of(*c);
  return baker != nullptr && mmverify_bake(baker, c->uv, c->level, map) != 0;
}

extern "C" const mmverify_subject_t* mmverify_subject_v1() {
  return baker_subject("mmverify", bake, [](mmverify_bake_support_t& it) {
    it.formats = 1U << MMVERIFY_4_STATE, it.texels = 1U << MMVERIFY_UNORM8;
    it.wraps = ~(1U << MMVERIFY_CLAMP_TO_BORDER) & 0x1fU;
    it.restrictions = MMVERIFY_BAKE_NO_FACTORS | MMVERIFY_BAKE_NO_MARGIN;
    it.unknown = MMVERIFY_UNKNOWN_BY_CENTROID;
  });
}
