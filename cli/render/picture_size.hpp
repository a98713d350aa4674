// The option --size of commands that render.
#pragma once

#include <cstdint>

namespace CLI {
class App;
}

namespace mmverify::cli {

/// Width and height in pixels.
struct PictureSize {
  std::uint32_t width = 640, height = 480;
};

/// Adds --size WIDTHxHEIGHT, each 1 to 4096. The option's check returns the fault of another text.
void add_picture_size(CLI::App& command, PictureSize& size);

}  // namespace mmverify::cli
