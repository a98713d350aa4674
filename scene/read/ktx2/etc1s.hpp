// Pictures of ETC1S blocks in BasisLZ.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/read/ktx2/container.hpp"
#include "scene/read/ktx2/prefix_code.hpp"
#include "scene/read/ktx2/uastc.hpp"

namespace mmverify::scene {

/// The colour and the row of ETC1's table of modifiers that a block has.
struct Etc1sEnd {
  std::array<std::uint8_t, 3> colour;  ///< of 31
  std::uint8_t table;
};

/// Two bits for each texel of a block, a byte a row, the left texel lowest.
using Etc1sSelectors = std::array<std::uint8_t, 4>;

/// Codebooks and Huffman codes that all slices of a file share.
struct Etc1sCodebooks {
  std::vector<Etc1sEnd> ends;
  std::vector<Etc1sSelectors> selectors;
  PrefixCode predictions, end_steps, selector_symbols, run_lengths;
  std::uint32_t history = 0;  ///< selectors that a slice remembers
};

/// Bytes of level 0's slices: colour, and alpha where there is one.
struct Etc1sSlices {
  Ktx2Bytes colour, alpha;
};

/// Errors: DamagedPicture.
/// Source: KTX File Format Specification 2.0, BasisLZ Global Data, and BasisLZ/ETC1S, ETC1S Endpoint Codebooks to
/// ETC1S Slice Huffman Tables.
Etc1sCodebooks etc1s_codebooks(const Ktx2& ktx2);
Etc1sSlices etc1s_slices(const Ktx2& ktx2);

/// The numbers of a block in the codebooks.
struct Etc1sBlock {
  std::uint16_t end, selectors;
};

/// The blocks of a slice, row by row.  Each number is below its codebook's size.
/// Errors: DamagedPicture.  Memory grows with the blocks that are read.
/// Source: the same specification, ETC1S Slice Decoding.
std::vector<Etc1sBlock> etc1s_blocks(const Etc1sCodebooks& books, Ktx2Bytes slice, std::uint32_t width,
                                     std::uint32_t height);

/// The 16 texels of a block, row by row; alpha is 255.
///   colour = clamp(c * 8 + c / 4 + m, 0, 255), m = -b, -a, a, b of the table's row for the selectors 0 to 3
/// Source: Khronos Data Format Specification 1.4, 21 (ETC1 and ETC1S).
RgbaTexels texels_of_etc1s(const Etc1sEnd& end, const Etc1sSelectors& selectors);

}  // namespace mmverify::scene
