// The container KTX2: its header, its index, and what its data are.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace mmverify::scene {

using Ktx2Bytes = std::span<const unsigned char>;

enum class Ktx2Coding : std::uint8_t { plain, bc1, bc2, bc3, bc7, opaque_8, opaque_16, uastc, etc1s, unread };

/// The numbers of a plain texel.
enum class Ktx2Number : std::uint8_t { byte, word, half, single };

enum class Ktx2Scheme : std::uint8_t { none, basis_lz, zstandard, zlib };

/// Level 0 of a KTX2 of one 2D picture.
struct Ktx2 {
  std::uint32_t width = 0, height = 0;
  std::uint64_t levels = 1;
  Ktx2Coding coding = Ktx2Coding::unread;
  unsigned channels = 0;  ///< of a plain texel
  Ktx2Number number = Ktx2Number::byte;
  bool blue_first = false;     ///< of a plain texel
  bool srgb = false;           ///< the transfer function of its descriptor
  bool premultiplied = false;  ///< the flag of its descriptor
  bool has_alpha_slice = false;
  Ktx2Scheme scheme = Ktx2Scheme::none;
  Ktx2Bytes level;   ///< as it lies in the file
  Ktx2Bytes global;  ///< of BasisLZ
  std::uint64_t uncompressed = 0;
  std::string why;  ///< a sentence if it is not read
};

/// Reads header, index, data format descriptor and key/value data.
/// Errors: DamagedPicture if the file is cut off, a part lies outside the file or overlaps another one, or a
/// level is beyond the smallest.
/// Source: KTX File Format Specification 2.0, 3 and 4; Khronos Data Format Specification 1.4, 5.
/// Test: ktx2_test cuts files at every byte and moves each part.
Ktx2 ktx2_of(Ktx2Bytes bytes);

std::size_t bytes_of(Ktx2Number number) noexcept;

/// Bytes of a block, or of a plain texel.
std::size_t unit_bytes(const Ktx2& ktx2);

/// Bytes of level 0 before supercompression.  Domain: any coding but ETC1S.
std::uint64_t level_bytes(const Ktx2& ktx2);

}  // namespace mmverify::scene
