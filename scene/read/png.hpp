// Checks a PNG's chunks before it is decoded.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace mmverify::scene {

/// What is wrong with the chunks that decide its texels, or nothing: one is cut off, or its CRC is not that of its bytes;
/// IEND is missing.  Chunks that decide none, such as texts, are not looked into.
/// Source: PNG 3rd edition, 5.3, 13.2.
std::optional<std::string> damage_of_png(std::span<const unsigned char> bytes);

/// For a PNG of a palette with fewer colours than its samples can name: the same picture with a palette in which the
/// colours that are there are black, and all others white.  Empty for any other PNG.
/// Precondition: damage_of_png() is none.
std::vector<unsigned char> with_palette_marked(std::span<const unsigned char> bytes);

}  // namespace mmverify::scene
