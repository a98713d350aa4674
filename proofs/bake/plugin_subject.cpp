#include <cmath>
#include <cstring>

#include "proofs/bake/subject.hpp"
#include "subjects/dock/codec.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::proofs::bake {
namespace {

using dock::Call;
using dock::LibraryPtr;

static_assert(MMVERIFY_REPEAT == static_cast<int>(Wrap::repeat) &&
              MMVERIFY_MIRRORED_REPEAT == static_cast<int>(Wrap::mirrored_repeat) &&
              MMVERIFY_CLAMP_TO_EDGE == static_cast<int>(Wrap::clamp_to_edge) &&
              MMVERIFY_CLAMP_TO_BORDER == static_cast<int>(Wrap::clamp_to_border) &&
              MMVERIFY_MIRROR_CLAMP_TO_EDGE == static_cast<int>(Wrap::mirror_once) &&
              MMVERIFY_BILINEAR == static_cast<int>(Filter::bilinear) &&
              MMVERIFY_NEAREST == static_cast<int>(Filter::nearest));

/// The case in the C header's form, with its texels behind it up to the end of the blob.
std::vector<std::uint8_t> blob_of(const Case& one, Level n, Format format) {
  mmverify_bake_case_t what{};
  what.size = sizeof what;
  what.level = n;
  what.format = static_cast<std::uint32_t>(format);
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
  const std::size_t texel = std::size_t{1} << static_cast<unsigned>(one.texel);
  std::vector<std::uint8_t> blob(sizeof what + one.alpha.size() * texel);
  std::memcpy(blob.data(), &what, sizeof what);
  std::uint8_t* to = blob.data() + sizeof what;
  for (const std::uint32_t bits : one.alpha) {
    // The header's texels have the machine's byte order.
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
  return blob;
}

/// The support that the header's numbers describe; a zero means that all is supported.
Support supported(const mmverify_bake_support_t& says) {
  Support s;
  // Texels and alpha modes by the header's values.
  const auto set = [](std::uint32_t bits, unsigned first) { return bits == 0 ? Set() : Set(bits >> first); };
  const auto in = [](std::uint32_t bits, std::uint32_t value) {
    return bits == 0 || (bits >> value & 1) != 0;
  };
  const auto restricted = [&](std::uint32_t flag) { return (says.restrictions & flag) != 0; };
  if (says.max_level != 0) s.max_level = says.max_level;
  s.two_state = in(says.formats, MMVERIFY_2_STATE);
  s.four_state = in(says.formats, MMVERIFY_4_STATE);
  s.texels = set(says.texels, MMVERIFY_UNORM8);
  s.filters = set(says.filters, 0);
  s.wraps = set(says.wraps, 0);
  s.mask = in(says.alpha_modes, MMVERIFY_MASK);
  s.blend = in(says.alpha_modes, MMVERIFY_BLEND);
  if (says.max_side != 0) s.max_side = says.max_side;
  if (says.max_mips != 0) s.max_mips = says.max_mips;
  s.same_wraps = restricted(MMVERIFY_BAKE_SAME_WRAPS);
  s.powers_of_two = restricted(MMVERIFY_BAKE_POWERS_OF_TWO);
  s.factors = !restricted(MMVERIFY_BAKE_NO_FACTORS);
  s.margins = !restricted(MMVERIFY_BAKE_NO_MARGIN);
  s.float_cutoffs = restricted(MMVERIFY_BAKE_FLOAT_CUTOFFS);
  if (says.fixed_cutoff != 0) {
    constexpr std::uint32_t over = 1u << 31;
    s.fixed_cutoff =
        float_cutoff({static_cast<std::uint32_t>(std::ldexp(double{says.fixed_cutoff}, 31)), over});
  }
  s.uv_min = says.uv_min;
  s.uv_max = says.uv_max;
  s.above = says.opaque == MMVERIFY_OPAQUE_ABOVE_CUTOFF;
  if (says.contact == MMVERIFY_OPEN_MICRO_TRIANGLES) s.contact = spec::bake::Contact::open;
  s.unknown = static_cast<UnknownSide>(says.unknown);
  s.weight_bits = says.weight_bits;
  s.coordinate_bits = says.coordinate_bits;
  return s;
}
static_assert(MMVERIFY_UNKNOWN_TRANSPARENT == static_cast<int>(UnknownSide::transparent) &&
              MMVERIFY_UNKNOWN_BY_COVERAGE == static_cast<int>(UnknownSide::coverage));

}  // namespace

BakeSubjectPtr plugin_subject(const std::string& name, const LibraryPtr& library) {
  if (!library->offers(dock::Topic::bake)) return nullptr;
  Functions functions;
  functions.bake = [library](const Case& one, Level n, Format format) -> std::optional<Baked> {
    const std::vector<std::uint8_t> blob = blob_of(one, n, format);
    const dock::Answer answer = dock::ask(
        *library, {Call::bake, n, static_cast<std::uint32_t>(format), blob, packed_bytes(n, format)},
        [&] { return "baking " + text_of(one); });
    if (!answer.taken) return std::nullopt;
    return unpacked(answer.bytes, n, format);
  };
  functions.support = supported(library->description().bake_support);
  functions.tight = (library->description().flags & MMVERIFY_BAKE_TIGHT) != 0;
  functions.centroid = (library->description().flags & MMVERIFY_BAKE_CENTROID) != 0 ||
                       functions.support.unknown == UnknownSide::centroid;
  return std::make_shared<BakeSubject>(name, library->about(), std::move(functions), library->fingerprint());
}

}  // namespace mmverify::proofs::bake
