#include "proofs/bake/cases/header_case.hpp"

#include <cstring>

namespace mmverify::proofs::bake {

static_assert(MMVERIFY_REPEAT == static_cast<int>(Wrap::repeat) &&
              MMVERIFY_MIRRORED_REPEAT == static_cast<int>(Wrap::mirrored_repeat) &&
              MMVERIFY_CLAMP_TO_EDGE == static_cast<int>(Wrap::clamp_to_edge) &&
              MMVERIFY_CLAMP_TO_BORDER == static_cast<int>(Wrap::clamp_to_border) &&
              MMVERIFY_MIRROR_CLAMP_TO_EDGE == static_cast<int>(Wrap::mirror_once) &&
              MMVERIFY_BILINEAR == static_cast<int>(Filter::bilinear) &&
              MMVERIFY_NEAREST == static_cast<int>(Filter::nearest));

mmverify_bake_case_t header_case(const Case& one, Level n, std::uint32_t format) {
  mmverify_bake_case_t what{};
  what.size = sizeof what;
  what.level = n;
  what.format = format;
  what.width = one.width;
  what.height = one.height;
  what.mips = one.mips;
  what.texel = static_cast<std::uint32_t>(one.texel) + MMVERIFY_UNORM8;
  what.border = one.border;
  what.filter = static_cast<std::uint32_t>(one.filter);
  what.wrap_u = static_cast<std::uint32_t>(one.wrap_u);
  what.wrap_v = static_cast<std::uint32_t>(one.wrap_v);
  what.factor = one.factor;
  what.vertex_factor = one.vertex_factor;
  what.alpha_mode = one.blend ? MMVERIFY_BLEND : MMVERIFY_MASK;
  what.cutoff_numerator = one.cutoff.numerator;
  what.cutoff_denominator = one.cutoff.denominator;
  what.margin = one.margin;
  std::copy(one.uv.begin(), one.uv.end(), what.uv);
  return what;
}

std::vector<std::uint8_t> header_texels(const Case& one) {
  const std::size_t texel = std::size_t{1} << static_cast<unsigned>(one.texel);
  std::vector<std::uint8_t> bytes(one.alpha.size() * texel);
  std::uint8_t* to = bytes.data();
  for (const std::uint32_t bits : one.alpha) {
    if (texel == 1) {
      *to = static_cast<std::uint8_t>(bits);
    } else if (texel == 2) {
      const auto word = static_cast<std::uint16_t>(bits);
      std::memcpy(to, &word, texel);
    } else {
      std::memcpy(to, &bits, texel);
    }
    to += texel;
  }
  return bytes;
}

}  // namespace mmverify::proofs::bake
