#include "scene/read/dds.hpp"

#include <algorithm>
#include <string_view>

#include "impl/bake/blocks/bc.hpp"
#include "impl/bake/blocks/bc7.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/image.hpp"
#include "scene/read/word.hpp"

namespace mmverify::scene {
namespace {

using namespace impl::bake::blocks;

using DdsBytes = std::span<const unsigned char>;

enum class DdsFormat {
  bc1,
  bc2,
  bc3,
  bc7,
  no_alpha_8,
  no_alpha_16,
  alpha_byte,
  no_alpha_24,
  no_alpha_32,
  unread
};

struct DdsHeader {
  std::uint32_t width = 0, height = 0;
  std::size_t data = 0;  ///< where the largest level begins
  DdsFormat format = DdsFormat::unread;
  std::string why;  ///< if it is not read
};

constexpr std::size_t header_end = 128, dx10_end = 148;

/// DXGI_FORMAT's numbers.
DdsFormat of_dxgi(std::uint32_t number) {
  switch (number) {
    case 70:
    case 71:
    case 72: return DdsFormat::bc1;
    case 73:
    case 74:
    case 75: return DdsFormat::bc2;
    case 76:
    case 77:
    case 78: return DdsFormat::bc3;
    case 79:
    case 80:
    case 81: return DdsFormat::no_alpha_8;
    case 82:
    case 83:
    case 84:
    case 94:
    case 95:
    case 96: return DdsFormat::no_alpha_16;
    case 97:
    case 98:
    case 99: return DdsFormat::bc7;
    case 27:
    case 28:
    case 29:
    case 87:
    case 90:
    case 91: return DdsFormat::alpha_byte;
    case 88:
    case 92:
    case 93: return DdsFormat::no_alpha_32;
    default: return DdsFormat::unread;
  }
}

DdsFormat of_four_cc(std::string_view code) {
  if (code == "DXT1") return DdsFormat::bc1;
  if (code == "DXT2" || code == "DXT3") return DdsFormat::bc2;
  if (code == "DXT4" || code == "DXT5") return DdsFormat::bc3;
  if (code == "ATI1" || code == "BC4U" || code == "BC4S") return DdsFormat::no_alpha_8;
  if (code == "ATI2" || code == "BC5U" || code == "BC5S") return DdsFormat::no_alpha_16;
  return DdsFormat::unread;
}

/// Texels without blocks, by the masks of the header.
DdsFormat of_masks(DdsBytes bytes, std::uint32_t flags) {
  constexpr std::uint32_t alpha_pixels = 0x1, rgb = 0x40;
  constexpr std::size_t bits_at = 88, alpha_mask_at = 104;
  if ((flags & rgb) == 0) return DdsFormat::unread;
  const std::uint32_t bits = word_at(bytes, bits_at);
  if (bits == 24) return DdsFormat::no_alpha_24;
  if (bits != 32) return DdsFormat::unread;
  if ((flags & alpha_pixels) == 0) return DdsFormat::no_alpha_32;
  return word_at(bytes, alpha_mask_at) == 0xff000000 ? DdsFormat::alpha_byte : DdsFormat::unread;
}

/// None if the header is cut off or is none.
std::optional<DdsHeader> header_of(DdsBytes bytes) {
  constexpr std::size_t height_at = 12, width_at = 16, flags_at = 80, code_at = 84, caps2_at = 112,
                        misc_at = 136;
  if (bytes.size() < header_end || word_at(bytes, 4) != 124) return {};
  DdsHeader header;
  header.width = word_at(bytes, width_at);
  header.height = word_at(bytes, height_at);
  header.data = header_end;
  const std::uint32_t flags = word_at(bytes, flags_at);
  const std::string code(reinterpret_cast<const char*>(bytes.data()) + code_at, 4);
  constexpr std::uint32_t has_code = 0x4, cube_or_volume = 0x200 | 0x200000, cube = 0x4;
  bool other_shape = (word_at(bytes, caps2_at) & cube_or_volume) != 0;
  if ((flags & has_code) != 0 && code == "DX10") {
    if (bytes.size() < dx10_end) return {};
    header.data = dx10_end;
    const std::uint32_t number = word_at(bytes, header_end);
    header.format = of_dxgi(number);
    header.why = "a DDS of DXGI format " + std::to_string(number);
    other_shape |= (word_at(bytes, misc_at) & cube) != 0;
  } else if ((flags & has_code) != 0) {
    header.format = of_four_cc(code);
    header.why = "a DDS of format '" + shown(code) + "'";
  } else {
    header.format = of_masks(bytes, flags);
    header.why = "a DDS of these masks";
  }
  if (other_shape) {
    header.format = DdsFormat::unread;
    header.why = "a DDS of a cube or a volume";
  }
  header.why += " is not read here";
  return header;
}

/// Bytes of a block of 4 x 4 texels; 0 for texels without blocks.
std::size_t block_bytes(DdsFormat format) {
  if (format == DdsFormat::bc1 || format == DdsFormat::no_alpha_8) return 8;
  constexpr DdsFormat of_16[] = {DdsFormat::bc2, DdsFormat::bc3, DdsFormat::bc7, DdsFormat::no_alpha_16};
  if (std::find(std::begin(of_16), std::end(of_16), format) != std::end(of_16)) return 16;
  return 0;
}

std::size_t data_bytes(const DdsHeader& header) {
  if (const std::size_t block = block_bytes(header.format); block != 0)
    return count_blocks(header.width, header.height) * block;
  return std::size_t{header.width} * header.height * (header.format == DdsFormat::no_alpha_24 ? 3 : 4);
}

}  // namespace

std::optional<std::string> why_unread_dds(DdsBytes bytes) {
  const auto header = header_of(bytes);
  if (!header || header->format != DdsFormat::unread) return std::nullopt;
  return header->why;
}

void decode_dds_alpha(DdsBytes bytes, Image& image, const std::string& file, const std::string& place) {
  const auto header = header_of(bytes);
  if (!header) throw BadScene(file, place, "a DDS without a whole header; truncated file?");
  if (header->format == DdsFormat::unread) throw UnreadExtension(file, place, header->why);
  check_sides(header->width, header->height, "a DDS", file, place);
  const std::size_t due = data_bytes(*header);
  if (bytes.size() - header->data < due)
    throw BadScene(file, place,
                   "a DDS of " + std::to_string(header->width) + " x " + std::to_string(header->height) +
                       " texels has " + std::to_string(due) + " bytes of them, there are " +
                       std::to_string(bytes.size() - header->data) + "; truncated file?");
  const DdsBytes data = bytes.subspan(header->data, due);
  image.width = header->width;
  image.height = header->height;
  const std::size_t texels = std::size_t{header->width} * header->height;
  switch (header->format) {
    case DdsFormat::bc1:
      image.alpha = alpha_of_blocks(image.width, image.height, data, 8, alpha_of_bc1);
      return;
    case DdsFormat::bc2:
      image.alpha = alpha_of_blocks(image.width, image.height, data, 16, alpha_of_bc2);
      return;
    case DdsFormat::bc3:
      image.alpha = alpha_of_blocks(image.width, image.height, data, 16, alpha_of_bc3);
      return;
    case DdsFormat::bc7:
      image.alpha = alpha_of_blocks(image.width, image.height, data, 16, alpha_of_bc7);
      return;
    case DdsFormat::alpha_byte: {
      std::vector<std::uint8_t> alpha(texels);
      for (std::size_t k = 0; k < texels; ++k) alpha[k] = data[4 * k + 3];
      image.alpha = std::move(alpha);
      return;
    }
    default: image.alpha = std::vector<std::uint8_t>(texels, 255);
  }
}

}  // namespace mmverify::scene
