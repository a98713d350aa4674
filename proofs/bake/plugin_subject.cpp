#include <cmath>
#include <cstring>

#include "proofs/bake/cases/header_case.hpp"
#include "proofs/bake/mesh/mesh_baker.hpp"
#include "proofs/bake/subject.hpp"
#include "subjects/dock/codec.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::proofs::bake {
namespace {

using dock::Call;
using dock::LibraryPtr;

/// The case in the C header's form, with its texels behind it up to the end of the blob.
std::vector<std::uint8_t> blob_of(const Case& one, Level n, Format format) {
  const mmverify_bake_case_t what = header_case(one, n, static_cast<std::uint32_t>(format));
  const std::vector<std::uint8_t> texels = header_texels(one);
  std::vector<std::uint8_t> blob(sizeof what);
  std::memcpy(blob.data(), &what, sizeof what);
  blob.insert(blob.end(), texels.begin(), texels.end());
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
  if (library->offers(Call::bake))
    functions.bake = [library](const Case& one, Level n, Format format) -> std::optional<Baked> {
      const std::vector<std::uint8_t> blob = blob_of(one, n, format);
      const dock::Answer answer = dock::ask(
          *library, {Call::bake, n, static_cast<std::uint32_t>(format), blob, packed_bytes(n, format)},
          [&] { return "baking " + text_of(one); });
      if (!answer.taken) return std::nullopt;
      return unpacked(answer.bytes, n, format);
    };
  if (library->offers(Call::bake_mesh)) functions.bake_mesh = mesh_baker_of(library);
  const std::uint32_t flags = library->description().flags;
  functions.support = supported(library->description().bake_support);
  functions.tight = (flags & MMVERIFY_BAKE_TIGHT) != 0;
  functions.own_levels = (flags & MMVERIFY_MESH_OWN_LEVELS) != 0;
  functions.centroid =
      (flags & MMVERIFY_BAKE_CENTROID) != 0 || functions.support.unknown == UnknownSide::centroid;
  return std::make_shared<BakeSubject>(name, library->about(), std::move(functions), library->fingerprint());
}

}  // namespace mmverify::proofs::bake
