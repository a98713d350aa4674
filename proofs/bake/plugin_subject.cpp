#include "proofs/bake/plugin_subject.hpp"

#include <algorithm>
#include <cstring>

#include "dock/codec.hpp"
#include "sdk/mmverify_subject.h"

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

/// The case as the header has it and, behind it, its texels: those end where the blob does.
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
    // The header's texels are the machine's own numbers.
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

}  // namespace

BakeSubjectPtr plugin_subject(const std::string& name, const LibraryPtr& library) {
  if (!library->offers(dock::Topic::bake)) return nullptr;
  Functions functions;
  functions.bake = [library](const Case& one, Level n, Format format) -> std::optional<Baked> {
    const std::size_t bits = static_cast<std::size_t>(format), count = std::size_t{1} << 2 * n;
    const std::vector<std::uint8_t> blob = blob_of(one, n, format);
    const dock::Answer answer =
        dock::ask(*library, {Call::bake, n, static_cast<std::uint32_t>(format), blob, (count * bits + 7) / 8},
                  [&] { return "baking " + text_of(one); });
    if (!answer.taken) return std::nullopt;
    Baked baked;
    const auto state = [&](std::size_t k) {
      return answer.bytes.at(k * bits / 8) >> k * bits % 8 & ((1u << bits) - 1);
    };
    for (std::size_t k = 0; k < count; ++k) baked.states.push_back(static_cast<State>(state(k)));
    for (std::size_t k = count; k * bits < 8 * answer.bytes.size(); ++k)
      baked.padded = baked.padded && state(k) == 0;
    return baked;
  };
  functions.centroid = (library->description().flags & MMVERIFY_BAKE_CENTROID) != 0;
  return std::make_shared<BakeSubject>(name, library->about(), std::move(functions), library->fingerprint());
}

}  // namespace mmverify::proofs::bake
