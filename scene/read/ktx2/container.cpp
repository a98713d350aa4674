#include "scene/read/ktx2/container.hpp"

#include <algorithm>
#include <bit>
#include <string_view>
#include <vector>

#include "impl/bake/blocks/bc.hpp"
#include "scene/read/damaged_picture.hpp"
#include "scene/read/word.hpp"

namespace mmverify::scene {
namespace {

constexpr std::size_t index_at = 48, levels_at = 80, bytes_of_level = 24;

std::uint64_t ktx2_long(Ktx2Bytes bytes, std::size_t at) {
  return word_at(bytes, at) | std::uint64_t{word_at(bytes, at + 4)} << 32;
}

/// A range of the file that the index names.
struct Ktx2Part {
  std::string name;
  std::uint64_t begin, length;
};

Ktx2Bytes bytes_of(Ktx2Bytes bytes, const Ktx2Part& part) {
  if (part.length == 0) return {};
  if (part.begin > bytes.size() || part.length > bytes.size() - part.begin)
    throw DamagedPicture(part.name + " lies at bytes " + std::to_string(part.begin) + " and has " +
                         std::to_string(part.length) + ", the file has " + std::to_string(bytes.size()) +
                         "; truncated file?");
  return bytes.subspan(static_cast<std::size_t>(part.begin), static_cast<std::size_t>(part.length));
}

/// Precondition: each part lies within the file.
void check_apart(std::vector<Ktx2Part> parts) {
  std::erase_if(parts, [](const Ktx2Part& part) { return part.length == 0; });
  std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
  for (std::size_t k = 1; k < parts.size(); ++k)
    if (parts[k].begin < parts[k - 1].begin + parts[k - 1].length)
      throw DamagedPicture(parts[k].name + " overlaps " + parts[k - 1].name);
}

/// A format that is not read, by its family's name and its number of VkFormat.
std::string unread_format(std::uint32_t number) {
  struct Family {
    std::uint32_t first, last;
    const char* name;
  };
  constexpr Family families[] = {{147, 152, "ETC2"},
                                 {153, 156, "EAC"},
                                 {157, 184, "ASTC"},
                                 {1000054000, 1000054007, "PVRTC"},
                                 {1000066000, 1000066013, "ASTC of HDR"}};
  const std::string its = "Vulkan's format " + std::to_string(number);
  for (const Family& family : families)
    if (number >= family.first && number <= family.last)
      return std::string(family.name) + " (" + its + "; UASTC is read: toktx --encode uastc OUT.ktx2 IN.png)";
  return its;
}

/// Vulkan's formats: the numbers of VkFormat.
void set_format(Ktx2& ktx2, std::uint32_t number) {
  struct Format {
    std::uint32_t number, variant;  ///< the variant is sRGB, or signed
    Ktx2Coding coding;
    unsigned channels;
    bool blue_first;
    Ktx2Number kind = Ktx2Number::byte;
  };
  using enum Ktx2Coding;
  using enum Ktx2Number;
  constexpr Format formats[] = {
      {9, 15, plain, 1, false},         {16, 22, plain, 2, false},        {23, 29, plain, 3, false},
      {30, 36, plain, 3, true},         {37, 43, plain, 4, false},        {44, 50, plain, 4, true},
      {51, 57, plain, 4, false},        {131, 132, opaque_8, 0, {}},      {133, 134, bc1, 0, {}},
      {135, 136, bc2, 0, {}},           {137, 138, bc3, 0, {}},           {139, 140, opaque_8, 0, {}},
      {141, 142, opaque_16, 0, {}},     {143, 144, opaque_16, 0, {}},     {145, 146, bc7, 0, {}},
      {70, 70, plain, 1, {}, word},     {77, 77, plain, 2, {}, word},     {84, 84, plain, 3, {}, word},
      {91, 91, plain, 4, {}, word},     {76, 76, plain, 1, {}, half},     {83, 83, plain, 2, {}, half},
      {90, 90, plain, 3, {}, half},     {97, 97, plain, 4, {}, half},     {100, 100, plain, 1, {}, single},
      {103, 103, plain, 2, {}, single}, {106, 106, plain, 3, {}, single}, {109, 109, plain, 4, {}, single}};
  for (const Format& format : formats)
    if (number == format.number || number == format.variant) {
      ktx2.coding = format.coding;
      ktx2.channels = format.channels;
      ktx2.blue_first = format.blue_first;
      ktx2.number = format.kind;
      return;
    }
  ktx2.why = "a KTX2 of " + unread_format(number);
}

/// ETC1S or UASTC, by the model and the channels of the descriptor.
void set_universal(Ktx2& ktx2, std::uint32_t model, const std::vector<std::uint32_t>& channels) {
  constexpr std::uint32_t etc1s = 163, uastc = 166;
  constexpr std::uint32_t rgb = 0, rgba = 3, rrr = 4, etc1s_rrr = 3, etc1s_alpha = 15;
  if (model == uastc && channels.size() == 1 &&
      (channels[0] == rgb || channels[0] == rgba || channels[0] == rrr)) {
    ktx2.coding = Ktx2Coding::uastc;
  } else if (model == etc1s && (channels == std::vector{rgb} || channels == std::vector{etc1s_rrr} ||
                                channels == std::vector{rgb, etc1s_alpha})) {
    ktx2.coding = Ktx2Coding::etc1s;
    ktx2.has_alpha_slice = channels.size() == 2;
  } else {
    ktx2.why = "a KTX2 of the colour model " + std::to_string(model) + " with the channels";
    for (const std::uint32_t channel : channels) ktx2.why += ' ' + std::to_string(channel);
  }
}

/// The basic block of the descriptor: transfer function, flags, and the model where Vulkan has no format.
void read_descriptor(Ktx2& ktx2, Ktx2Bytes descriptor, bool has_format) {
  constexpr std::size_t block_at = 4, block_head = 24, bytes_of_sample = 16;
  constexpr std::uint32_t transfer_srgb = 2, flag_premultiplied = 1;
  if (descriptor.size() < block_at + block_head) throw DamagedPicture("no whole data format descriptor");
  const std::size_t size = word_at(descriptor, block_at + 4) >> 16;
  if (size < block_head || size > descriptor.size() - block_at)
    throw DamagedPicture("its data format descriptor has " + std::to_string(descriptor.size()) +
                         " bytes, and a block of " + std::to_string(size));
  const std::uint32_t colour = word_at(descriptor, block_at + 8);
  ktx2.srgb = (colour >> 16 & 0xff) == transfer_srgb;
  ktx2.premultiplied = (colour >> 24 & flag_premultiplied) != 0;
  if (has_format) return;
  std::vector<std::uint32_t> channels;
  for (std::size_t at = block_head; at + bytes_of_sample <= size; at += bytes_of_sample)
    channels.push_back(descriptor[block_at + at + 3] & 15u);
  set_universal(ktx2, colour & 0xff, channels);
}

/// Keys that say how texels are turned or exchanged: only the values of glTF are read.
void check_keys(Ktx2& ktx2, Ktx2Bytes data) {
  struct Key {
    std::string_view name, value;
  };
  constexpr Key keys[] = {{"KTXswizzle", "rgba"}, {"KTXorientation", "rd"}};
  while (!data.empty()) {
    const std::size_t length = data.size() < 4 ? 0 : word_at(data, 0);
    if (data.size() < 4 || length > data.size() - 4)
      throw DamagedPicture("its key/value data end within an entry");
    const std::string_view entry(reinterpret_cast<const char*>(data.data()) + 4, length);
    const std::string_view name = entry.substr(0, entry.find('\0'));
    std::string_view value = entry.substr(std::min(name.size() + 1, entry.size()));
    value = value.substr(0, value.find('\0'));
    for (const Key& key : keys)
      if (name == key.name && value != key.value)
        ktx2.why = "a KTX2 with another " + std::string(name) + " than '" + std::string(key.value) + "'";
    data = data.subspan(std::min(data.size(), (4 + length + 3) / 4 * 4));
  }
}

void check_shape(Ktx2& ktx2, Ktx2Bytes bytes) {
  constexpr std::size_t depth_at = 28, layers_at = 32, faces_at = 36;
  if (word_at(bytes, depth_at) != 0) ktx2.why = "a KTX2 of a volume";
  if (word_at(bytes, layers_at) != 0) ktx2.why = "a KTX2 of an array";
  if (word_at(bytes, faces_at) != 1) ktx2.why = "a KTX2 of a cube";
}

void check_scheme(Ktx2& ktx2, std::uint32_t scheme) {
  constexpr std::uint32_t last = 3, first_of_vendors = 0x10000;
  if (scheme > last) {
    ktx2.why = std::string("a KTX2 with ") + (scheme < first_of_vendors ? "the" : "a vendor's") +
               " supercompression " + std::to_string(scheme);
    return;
  }
  ktx2.scheme = static_cast<Ktx2Scheme>(scheme);
  if (ktx2.coding != Ktx2Coding::unread &&
      (ktx2.coding == Ktx2Coding::etc1s) != (ktx2.scheme == Ktx2Scheme::basis_lz))
    throw DamagedPicture("its data are ETC1S without BasisLZ, or BasisLZ of other data than ETC1S");
}

}  // namespace

Ktx2 ktx2_of(Ktx2Bytes bytes) {
  constexpr std::size_t format_at = 12, width_at = 20, height_at = 24, count_at = 40, scheme_at = 44;
  constexpr std::string_view mark("\xabKTX 20\xbb\r\n\x1a\n", format_at);
  if (bytes.size() < levels_at || !std::equal(mark.begin(), mark.end(), bytes.begin(), [](char a, auto b) {
        return static_cast<unsigned char>(a) == b;
      }))
    throw DamagedPicture("no whole header; truncated file?");
  Ktx2 ktx2;
  ktx2.width = word_at(bytes, width_at);
  ktx2.height = word_at(bytes, height_at);
  ktx2.levels = std::max<std::uint64_t>(1, word_at(bytes, count_at));
  // Level k has sides of 2^-k, down to 1.
  if (ktx2.levels > static_cast<unsigned>(std::bit_width(std::max({ktx2.width, ktx2.height, 1u}))))
    throw DamagedPicture(std::to_string(ktx2.levels) + " levels of " + std::to_string(ktx2.width) + " x " +
                         std::to_string(ktx2.height) + " texels");
  const std::uint64_t index_end = levels_at + ktx2.levels * bytes_of_level;
  std::vector<Ktx2Part> parts{
      {"the index", 0, index_end},
      {"the data format descriptor", word_at(bytes, index_at), word_at(bytes, index_at + 4)},
      {"the key/value data", word_at(bytes, index_at + 8), word_at(bytes, index_at + 12)},
      {"the supercompression global data", ktx2_long(bytes, index_at + 16), ktx2_long(bytes, index_at + 24)}};
  bytes_of(bytes, parts[0]);
  for (std::size_t k = 0; k < ktx2.levels; ++k) {
    const std::size_t at = levels_at + k * bytes_of_level;
    parts.push_back({"level " + std::to_string(k), ktx2_long(bytes, at), ktx2_long(bytes, at + 8)});
  }
  for (const Ktx2Part& part : parts) bytes_of(bytes, part);
  check_apart(parts);
  ktx2.global = bytes_of(bytes, parts[3]);
  ktx2.level = bytes_of(bytes, parts[4]);
  ktx2.uncompressed = ktx2_long(bytes, levels_at + 16);
  const std::uint32_t format = word_at(bytes, format_at);
  if (format != 0) set_format(ktx2, format);
  read_descriptor(ktx2, bytes_of(bytes, parts[1]), format != 0);
  check_scheme(ktx2, word_at(bytes, scheme_at));
  check_keys(ktx2, bytes_of(bytes, parts[2]));
  check_shape(ktx2, bytes);
  if (!ktx2.why.empty()) ktx2.why += " is not read here";
#ifndef MMVERIFY_HAS_ZSTD
  if (ktx2.scheme == Ktx2Scheme::zstandard)
    ktx2.why = "this program was built without Zstandard (Debian: libzstd-dev)";
#endif
  return ktx2;
}

std::size_t bytes_of(Ktx2Number number) noexcept {
  return number == Ktx2Number::byte ? 1 : number == Ktx2Number::single ? 4 : 2;
}

std::size_t unit_bytes(const Ktx2& ktx2) {
  switch (ktx2.coding) {
    case Ktx2Coding::plain: return ktx2.channels * bytes_of(ktx2.number);
    case Ktx2Coding::bc1:
    case Ktx2Coding::opaque_8: return 8;
    default: return 16;
  }
}

std::uint64_t level_bytes(const Ktx2& ktx2) {
  const std::uint64_t units = ktx2.coding == Ktx2Coding::plain
                                  ? std::uint64_t{ktx2.width} * ktx2.height
                                  : impl::bake::blocks::count_blocks(ktx2.width, ktx2.height);
  return units * unit_bytes(ktx2);
}

}  // namespace mmverify::scene
