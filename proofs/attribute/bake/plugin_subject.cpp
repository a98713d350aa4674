#include <cstring>

#include "proofs/attribute/bake/cases.hpp"
#include "proofs/attribute/subject_parts.hpp"
#include "spec/attribute/order.hpp"
#include "subjects/dock/codec.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::proofs::attribute {
namespace {

using dock::Call;
using dock::LibraryPtr;

static_assert(MMVERIFY_NORMAL_AND_LENGTH == static_cast<int>(Meaning::normal_and_length) &&
              MMVERIFY_SRGB == static_cast<int>(Meaning::srgb) &&
              MMVERIFY_MIRROR_CLAMP_TO_EDGE == static_cast<int>(Wrap::mirror_once) &&
              MMVERIFY_NEAREST == static_cast<int>(Filter::nearest));

/// The case in the C header's form, with its texels behind it up to the end of the blob.
std::vector<std::uint8_t> blob_of(const BakeCase& one, Level n) {
  const Picture& p = one.picture;
  mmverify_attribute_case_t what{};
  what.size = sizeof what;
  what.level = n;
  what.width = p.width;
  what.height = p.height;
  what.texel = MMVERIFY_UNORM8;
  std::copy(p.border.begin(), p.border.end(), what.border);
  what.filter = static_cast<std::uint32_t>(p.filter);
  what.wrap_u = static_cast<std::uint32_t>(p.wrap_u);
  what.wrap_v = static_cast<std::uint32_t>(p.wrap_v);
  what.meaning = static_cast<std::uint32_t>(p.meaning);
  std::copy(one.uv.begin(), one.uv.end(), what.uv);
  const std::size_t texels = p.texels.size() * sizeof(Rgba);
  std::vector<std::uint8_t> blob(sizeof what + texels);
  std::memcpy(blob.data(), &what, sizeof what);
  std::memcpy(blob.data() + sizeof what, p.texels.data(), texels);
  return blob;
}

std::function<std::vector<Rgba>(const BakeCase&, Level)> baker(const LibraryPtr& library, Call call,
                                                               std::uint64_t (*values)(Level)) {
  if (!library->offers(call)) return {};
  return [=](const BakeCase& one, Level n) -> std::vector<Rgba> {
    const std::vector<std::uint8_t> blob = blob_of(one, n);
    std::vector<Rgba> map(values(n));
    const dock::Answer answer =
        dock::ask(*library, dock::Question{call, n, 0, blob, map.size() * sizeof(Rgba)},
                  [&] { return "baking " + text_of(one); });
    if (!answer.taken) return {};
    std::memcpy(map.data(), answer.bytes.data(), map.size() * sizeof(Rgba));
    return map;
  };
}

/// The support that the header's numbers describe; a zero means that all is supported.
BakingSupport supported(const mmverify_attribute_support_t& says) {
  const auto set = [](std::uint32_t bits) { return bits == 0 ? Set() : Set(bits); };
  BakingSupport s;
  if (says.max_level != 0) s.max_level = says.max_level;
  s.meanings = set(says.meanings);
  s.filters = set(says.filters);
  s.wraps = set(says.wraps);
  s.same_wraps = (says.restrictions & MMVERIFY_BAKE_SAME_WRAPS) != 0;
  s.tolerance = says.tolerance;
  return s;
}

}  // namespace

Baking baking_of(const LibraryPtr& library) {
  Baking f;
  f.support = supported(library->description().attribute_support);
  f.faces = baker(library, Call::attribute_bake_faces,
                  [](Level n) -> std::uint64_t { return spec::attribute::face_count(n); });
  f.vertices = baker(library, Call::attribute_bake_vertices,
                     [](Level n) -> std::uint64_t { return spec::attribute::vertex_count(n); });
  return f;
}

}  // namespace mmverify::proofs::attribute
