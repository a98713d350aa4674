// What goes in and out of programs that compress textures.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/attribute/texture_coder.hpp"

namespace mmverify::bench {

/// Errors: std::runtime_error where the disk is full.
void write_file(const std::string& path, const std::vector<unsigned char>& bytes);

/// The colours of a picture that a program wrote.  Errors: std::runtime_error where it is none, or of another size than
/// went in.
std::vector<std::uint8_t> rgb_of_png(const std::string& path, const scene::TexturePixels& pixels,
                                     const std::string& program);

/// Errors: std::runtime_error where the file has another size, or is not there.
void expect_size(const std::string& file, std::uint64_t bytes, const std::string& program);

}  // namespace mmverify::bench
