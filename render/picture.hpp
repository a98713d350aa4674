// Frames as pictures: what is seen, and how often the any-hit shader was called.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/blend.hpp"
#include "render/frame.hpp"
#include "render/world.hpp"

namespace mmverify::render {

struct Picture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< rows from the top
};

/// Each triangle in the colours of its map, where there are maps, else in its geometry's; darker away from the light and
/// in shadow; the sky behind.
Picture seen(const World& world, const Frame& frame, const ColourMaps* colours = nullptr);

/// What was accepted, as in seen() without shadows, and black where that is nothing; on it the payload, by the
/// operation.
Picture blended(const World& world, const BlendFrame& frame, const Blending& blending);

/// A pixel's calls, of primary and shadow ray, from dark blue (none) by green and yellow to red (`most` or more).
Picture heat(const Frame& frame, std::uint32_t most);
std::array<std::uint8_t, 3> heat_colour(std::uint32_t calls, std::uint32_t most);

/// The greatest number of calls that at least 1 pixel in 1000 has; at least 1: the end of a scale for heat().
std::uint32_t scale_of(const Frame& frame);

/// Pictures side by side, four to a row, each with a line of text above; below, a scale from 0 to `most`. As wide as the
/// texts need.
/// Letters are of 3 x 5 dots, twice as large: A to Z, 0 to 9 and -.,:/%; others are blank.
Picture side_by_side(const std::vector<Picture>& pictures, const std::vector<std::string>& titles,
                     std::uint32_t most);

}  // namespace mmverify::render
