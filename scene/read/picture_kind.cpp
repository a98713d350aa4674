#include "scene/read/picture_kind.hpp"

#include <array>
#include <cstring>
#include <string_view>

#include "scene/read/dds.hpp"
#include "scene/read/ktx2/ktx2.hpp"
#include "scene/read/rgba_image.hpp"
#include "scene/read/tga.hpp"

namespace mmverify::scene {
namespace {

using namespace std::string_view_literals;

struct PictureMark {
  std::size_t at;
  std::string_view bytes;
  PictureKind kind;
};

constexpr PictureMark marks[] = {
    {0, "\x89PNG\r\n\x1a\n"sv, PictureKind::png}, {0, "\xff\xd8\xff"sv, PictureKind::jpeg},
    {8, "WEBPVP8"sv, PictureKind::webp},          {4, "ftypavif"sv, PictureKind::avif},
    {4, "ftypavis"sv, PictureKind::avif},         {0, "DDS "sv, PictureKind::dds},
    {0, "\xabKTX 20\xbb"sv, PictureKind::ktx2},   {0, "\x76\x2f\x31\x01"sv, PictureKind::openexr}};

}  // namespace

PictureKind picture_kind(std::span<const unsigned char> bytes) {
  for (const PictureMark& mark : marks)
    if (bytes.size() >= mark.at + mark.bytes.size() &&
        std::memcmp(bytes.data() + mark.at, mark.bytes.data(), mark.bytes.size()) == 0)
      return mark.kind;
  return is_tga(bytes) ? PictureKind::tga : PictureKind::unknown;
}

const char* name_of(PictureKind kind) noexcept {
  constexpr std::array names{"PNG", "JPEG", "WebP", "AVIF", "DDS", "TGA", "KTX2", "OpenEXR", "unknown"};
  return names[static_cast<std::size_t>(kind)];
}

std::optional<std::string> why_unread(std::span<const unsigned char> bytes, PictureUse use) {
  switch (picture_kind(bytes)) {
    case PictureKind::webp:
#ifdef MMVERIFY_HAS_WEBP
      return std::nullopt;
#else
      return "this program was built without WebP (Debian: libwebp-dev)";
#endif
    case PictureKind::avif: return why_no_avif();
    case PictureKind::dds:
      if (use == PictureUse::colour) return "the colours of a DDS are not read here";
      return why_unread_dds(bytes);
    case PictureKind::ktx2: return why_unread_ktx2(bytes, use);
    case PictureKind::openexr:
      if (use == PictureUse::colour) return "the colours of an OpenEXR are not read here";
#ifdef MMVERIFY_HAS_OPENEXR
      return std::nullopt;
#else
      return "this program was built without OpenEXR (Debian: libopenexr-dev)";
#endif
    default: return std::nullopt;
  }
}

}  // namespace mmverify::scene
