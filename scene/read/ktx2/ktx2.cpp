#include "scene/read/ktx2/ktx2.hpp"

#ifdef MMVERIFY_HAS_ZSTD
#include <zstd.h>
#endif
#include <stb/stb_image.h>

#include <bit>
#include <cmath>
#include <limits>

#include "impl/bake/blocks/bc.hpp"
#include "impl/bake/blocks/bc7.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/damaged_picture.hpp"
#include "scene/read/image.hpp"
#include "scene/read/ktx2/container.hpp"
#include "scene/read/ktx2/etc1s.hpp"
#include "scene/read/ktx2/uastc.hpp"

namespace mmverify::scene {
namespace {

using namespace impl::bake::blocks;

bool has_colours(const Ktx2& ktx2) {
  return (ktx2.coding == Ktx2Coding::plain && ktx2.number == Ktx2Number::byte) ||
         ktx2.coding == Ktx2Coding::uastc || ktx2.coding == Ktx2Coding::etc1s;
}

/// Source: RFC 1950, 8.2, which has the checksum behind the data.
bool has_its_adler([[maybe_unused]] Ktx2Bytes code, [[maybe_unused]] Ktx2Bytes bytes) {
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  return true;  // or a fuzzer would get no further
#else
  constexpr std::uint32_t base = 65521;
  std::uint32_t a = 1, b = 0, due = 0;
  for (const unsigned char byte : bytes) {
    a = (a + byte) % base;
    b = (b + a) % base;
  }
  for (const unsigned char byte : code.last(4)) due = due << 8 | byte;
  return (b << 16 | a) == due;
#endif
}

/// Errors: DamagedPicture.
void undo_zlib(Ktx2Bytes code, std::uint64_t due, std::vector<unsigned char>& bytes) {
  constexpr std::size_t head_and_checksum = 6;
  if (code.size() < head_and_checksum) throw DamagedPicture("level 0 has no whole ZLIB; truncated file?");
  if (due > std::numeric_limits<int>::max())
    throw DamagedPicture("level 0 has " + std::to_string(due) + " bytes in ZLIB, of which 2^31 - 1 are read");
  bytes.resize(static_cast<std::size_t>(due));
  const int size =
      stbi_zlib_decode_buffer(reinterpret_cast<char*>(bytes.data()), static_cast<int>(due),
                              reinterpret_cast<const char*>(code.data()), static_cast<int>(code.size()));
  if (size < 0) throw DamagedPicture("ZLIB cannot undo level 0; truncated file?");
  if (static_cast<std::uint64_t>(size) != due)
    throw DamagedPicture("level 0 has " + std::to_string(due) + " bytes, ZLIB gives " + std::to_string(size));
  if (!has_its_adler(code, bytes))
    throw DamagedPicture("level 0 has another Adler-32 than its bytes; damaged file?");
}

/// Level 0 without its supercompression; the bytes lie in the file or in `storage`.
Ktx2Bytes level_of(const Ktx2& ktx2, std::vector<unsigned char>& storage) {
  const std::uint64_t due = level_bytes(ktx2);
  if (ktx2.uncompressed != due)
    throw DamagedPicture("level 0 of " + std::to_string(ktx2.width) + " x " + std::to_string(ktx2.height) +
                         " texels has " + std::to_string(due) + " bytes, the index says " +
                         std::to_string(ktx2.uncompressed));
  if (ktx2.scheme == Ktx2Scheme::none) {
    if (ktx2.level.size() != due)
      throw DamagedPicture("level 0 has " + std::to_string(due) + " bytes, there are " +
                           std::to_string(ktx2.level.size()) + "; truncated file?");
    return ktx2.level;
  }
  // So no small file claims gigabytes: a block of Zstandard takes at least 4 bytes and gives at most 2^17, and deflate
  // gives at most 1032 for one.
  const bool is_zlib = ktx2.scheme == Ktx2Scheme::zlib;
  if (is_zlib ? due / 1032 > ktx2.level.size() : due / (1u << 17) > ktx2.level.size() / 4)
    throw DamagedPicture("level 0 has " + std::to_string(due) + " bytes, which cannot be in " +
                         std::to_string(ktx2.level.size()) + " of " + (is_zlib ? "ZLIB" : "Zstandard") +
                         "; truncated file?");
  if (is_zlib) {
    undo_zlib(ktx2.level, due, storage);
    return storage;
  }
#ifdef MMVERIFY_HAS_ZSTD
  storage.resize(static_cast<std::size_t>(due));
  const std::size_t size =
      ZSTD_decompress(storage.data(), storage.size(), ktx2.level.data(), ktx2.level.size());
  if (ZSTD_isError(size))
    throw DamagedPicture(std::string("Zstandard cannot undo level 0 (") + ZSTD_getErrorName(size) + ")");
  if (size != due)
    throw DamagedPicture("level 0 has " + std::to_string(due) + " bytes, Zstandard gives " +
                         std::to_string(size));
#endif
  return storage;
}

/// Calls read(); a fault of the bytes becomes an error of the file and the place.
template <class Read>
auto named(const std::string& file, const std::string& place, Read read) {
  try {
    return read();
  } catch (const DamagedPicture& damage) {
    throw BadScene(file, place, std::string("a damaged KTX2: ") + damage.what());
  }
}

/// Header and index of a KTX2 that is read, with sides that are read.
Ktx2 checked_ktx2(Ktx2Bytes bytes, const std::string& file, const std::string& place) {
  Ktx2 ktx2 = ktx2_of(bytes);
  if (!ktx2.why.empty()) throw UnreadExtension(file, place, ktx2.why);
  check_sides(ktx2.width, ktx2.height, "a KTX2", file, place);
  return ktx2;
}

using RgbaTexel = std::array<std::uint8_t, 4>;

RgbaTexel plain_texel(const Ktx2& ktx2, Ktx2Bytes level, std::size_t k) {
  RgbaTexel texel{0, 0, 0, 255};
  std::copy_n(level.begin() + static_cast<std::ptrdiff_t>(k * ktx2.channels), ktx2.channels, texel.begin());
  if (ktx2.blue_first) std::swap(texel[0], texel[2]);
  return texel;
}

/// The 16 texels of block k of ETC1S.
class Etc1sPicture {
 public:
  explicit Etc1sPicture(const Ktx2& ktx2) : books_(etc1s_codebooks(ktx2)) {
    const Etc1sSlices slices = etc1s_slices(ktx2);
    const auto read = [&](const char* name, Ktx2Bytes slice) {
      return in_part(name, [&] { return etc1s_blocks(books_, slice, ktx2.width, ktx2.height); });
    };
    colour_ = read("the slice of colours", slices.colour);
    if (ktx2.has_alpha_slice) alpha_ = read("the slice of alpha", slices.alpha);
  }

  RgbaTexels operator()(std::size_t k) const {
    RgbaTexels texels = decoded(colour_[k]);
    if (alpha_.empty()) return texels;
    // The KTX specification names red.  Encoder and decoder of Basis Universal take green, and a block's
    // channels may differ.
    const RgbaTexels alphas = decoded(alpha_[k]);
    for (std::size_t t = 0; t < texels.size(); ++t) texels[t][3] = alphas[t][1];
    return texels;
  }

 private:
  RgbaTexels decoded(const Etc1sBlock& block) const {
    return texels_of_etc1s(books_.ends[block.end], books_.selectors[block.selectors]);
  }

  Etc1sCodebooks books_;
  std::vector<Etc1sBlock> colour_, alpha_;
};

/// Calls put(k, texel) for each texel k; precondition: has_colours().
template <class Put>
void each_texel(const Ktx2& ktx2, Put put) {
  if (ktx2.coding == Ktx2Coding::etc1s)
    return each_texel_of_blocks(ktx2.width, ktx2.height, Etc1sPicture(ktx2), put);
  std::vector<unsigned char> storage;
  const Ktx2Bytes level = level_of(ktx2, storage);
  if (ktx2.coding == Ktx2Coding::uastc)
    return each_texel_of_blocks(
        ktx2.width, ktx2.height,
        [&](std::size_t k) { return texels_of_uastc(level.subspan(16 * k, 16), ktx2.srgb); }, put);
  const std::size_t texels = std::size_t{ktx2.width} * ktx2.height;
  for (std::size_t k = 0; k < texels; ++k) put(k, plain_texel(ktx2, level, k));
}

/// The channels `first` to 3 of all texels.
std::vector<std::uint8_t> channels_of(const Ktx2& ktx2, std::size_t first) {
  const std::size_t count = 4 - first;
  std::vector<std::uint8_t> samples;
  each_texel(ktx2, [&](std::size_t k, const RgbaTexel& texel) {
    // Here, since the bytes are known to be sound by then.
    if (samples.empty()) samples.resize(count * ktx2.width * ktx2.height);
    for (std::size_t channel = 0; channel < count; ++channel)
      samples[count * k + channel] = texel[first + channel];
  });
  return samples;
}

std::uint32_t number_at(Ktx2Bytes level, std::size_t at, std::size_t bytes) {
  std::uint32_t number = 0;
  for (std::size_t k = 0; k < bytes; ++k) number |= std::uint32_t{level[at + k]} << 8 * k;
  return number;
}

/// Source: IEEE 754, 3.4, binary16.
float number_of_half(std::uint32_t bits) {
  const int exponent = static_cast<int>(bits >> 10 & 31), fraction = static_cast<int>(bits & 1023);
  const float size = exponent == 31  ? std::numeric_limits<float>::infinity()
                     : exponent == 0 ? std::ldexp(static_cast<float>(fraction), -24)
                                     : std::ldexp(static_cast<float>(fraction + 1024), exponent - 25);
  return (bits & 0x8000) != 0 ? -size : size;
}

/// The alpha of plain texels; 1 where they have none.
/// Errors: DamagedPicture for a number that is not finite.
decltype(Image::alpha) alpha_of_numbers(const Ktx2& ktx2) {
  std::vector<unsigned char> storage;
  const Ktx2Bytes level = level_of(ktx2, storage);
  const std::size_t texels = std::size_t{ktx2.width} * ktx2.height, width = bytes_of(ktx2.number),
                    unit = unit_bytes(ktx2);
  const bool has_alpha = ktx2.channels == 4;
  const auto bits = [&](std::size_t k) { return number_at(level, k * unit + 3 * width, width); };
  if (ktx2.number == Ktx2Number::word) {
    std::vector<std::uint16_t> alpha(texels, 65535);
    for (std::size_t k = 0; k < texels && has_alpha; ++k) alpha[k] = static_cast<std::uint16_t>(bits(k));
    return alpha;
  }
  std::vector<float> alpha(texels, 1);
  for (std::size_t k = 0; k < texels && has_alpha; ++k) {
    alpha[k] = ktx2.number == Ktx2Number::half ? number_of_half(bits(k)) : std::bit_cast<float>(bits(k));
    if (!std::isfinite(alpha[k]))
      throw DamagedPicture("the alpha of texel " + std::to_string(k) + " is not finite");
  }
  return alpha;
}

/// Precondition: the coding is one of the BCs.
decltype(Image::alpha) alpha_of_bc(const Ktx2& ktx2) {
  std::vector<unsigned char> storage;
  const Ktx2Bytes level = level_of(ktx2, storage);
  switch (ktx2.coding) {
    case Ktx2Coding::bc1: return alpha_of_blocks(ktx2.width, ktx2.height, level, 8, alpha_of_bc1);
    case Ktx2Coding::bc2: return alpha_of_blocks(ktx2.width, ktx2.height, level, 16, alpha_of_bc2);
    case Ktx2Coding::bc3: return alpha_of_blocks(ktx2.width, ktx2.height, level, 16, alpha_of_bc3);
    case Ktx2Coding::bc7: return alpha_of_blocks(ktx2.width, ktx2.height, level, 16, alpha_of_bc7);
    default: return std::vector<std::uint8_t>(std::size_t{ktx2.width} * ktx2.height, 255);
  }
}

}  // namespace

std::optional<std::string> why_unread_ktx2(Ktx2Bytes bytes, PictureUse use) {
  try {
    const Ktx2 ktx2 = ktx2_of(bytes);
    if (!ktx2.why.empty()) return ktx2.why;
    if (use == PictureUse::alpha) return std::nullopt;
    if (ktx2.coding == Ktx2Coding::plain && !has_colours(ktx2))
      return "the colours of a KTX2 of 16 or 32 bits a channel are not read here";
    if (!has_colours(ktx2)) return "the colours of a KTX2 of BC1 to BC7 are not read here";
    if (ktx2.premultiplied) return "the colours of a KTX2 are not read here where alpha multiplies them";
    return std::nullopt;
  } catch (const DamagedPicture&) {
    return std::nullopt;
  }
}

RgbaImage decode_ktx2(Ktx2Bytes bytes, const std::string& file, const std::string& place) {
  return named(file, place, [&] {
    const Ktx2 ktx2 = checked_ktx2(bytes, file, place);
    if (const auto why = why_unread_ktx2(bytes, PictureUse::colour)) throw UnreadExtension(file, place, *why);
    return RgbaImage{ktx2.width, ktx2.height, channels_of(ktx2, 0)};
  });
}

void decode_ktx2_alpha(Ktx2Bytes bytes, Image& image, const std::string& file, const std::string& place) {
  named(file, place, [&] {
    const Ktx2 ktx2 = checked_ktx2(bytes, file, place);
    image.width = ktx2.width;
    image.height = ktx2.height;
    if (has_colours(ktx2))
      image.alpha = channels_of(ktx2, 3);
    else
      image.alpha = ktx2.coding == Ktx2Coding::plain ? alpha_of_numbers(ktx2) : alpha_of_bc(ktx2);
  });
}

}  // namespace mmverify::scene
