// Checks of a PNG's chunks before it is decoded.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mmverify::scene {

/// The damage of the chunks that decide the texels, or none.  A chunk is damaged if it is cut off or its CRC
/// is not that of its bytes; IEND may also be missing.  Other chunks, such as texts, are not checked.
/// Source: PNG 3rd edition, 5.3, 13.2.
std::optional<std::string> damage_of_png(std::span<const unsigned char> bytes);

/// The same picture with a marked palette, if a PNG has a palette with fewer colours than its samples can
/// name: colours of the palette are black, and all others white.  Empty for any other PNG.
/// Precondition: damage_of_png() is none.
std::vector<unsigned char> with_palette_marked(std::span<const unsigned char> bytes);

}  // namespace mmverify::scene
