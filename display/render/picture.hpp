// Pictures of frames: the camera's view, and the number of any-hit calls.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "display/render/blend.hpp"
#include "display/render/frame.hpp"
#include "display/render/world.hpp"

namespace mmverify::render {

struct Picture {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgb;  ///< rows from the top
};

/// The picture that the camera sees.  A triangle has the colours of its map, or else its geometry's colour;
/// it is darker away from the light and in shadow, and in proportion to the rays of ambient occlusion that met
/// something.  The sky is behind.
Picture seen(const World& world, const Frame& frame, const ColourMaps* colours = nullptr);

/// The accepted hits as in seen() without shadows, black if there is none, with the payload blended on top.
Picture blended(const World& world, const BlendFrame& frame, const Blending& blending);

/// The any-hit calls of all rays of each pixel, from dark blue (none) by green and yellow to red
/// (`most` or more).
Picture heat(const Frame& frame, std::uint32_t most);
std::array<std::uint8_t, 3> heat_colour(std::uint32_t calls, std::uint32_t most);

/// The end of a scale for heat(): the greatest number of calls that at least 1 pixel in 1000 reaches, at
/// least 1.
std::uint32_t scale_of(const Frame& frame);

/// Pictures side by side, four a row, each below its title, and below all a scale from 0 to `most`, whose end
/// `unit` names; none if most is 0.  The picture is as wide as the texts need.
/// Letters have 3 x 5 dots of 2 x 2 pixels: A to Z, 0 to 9 and -.,:/%; others are blank.
Picture side_by_side(const std::vector<Picture>& pictures, const std::vector<std::string>& titles,
                     std::uint32_t most, const std::string& unit = "any-hit calls a pixel or more");

}  // namespace mmverify::render
