// The images of a document: those whose alpha counts are decoded, side by side.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "scene/read/buffers.hpp"
#include "scene/read/document.hpp"
#include "scene/scene.hpp"

namespace mmverify::scene {

/// Checks that all images are there, and decodes those in `to_decode` on all cores.
/// Errors: BadScene, of several faulty images the first one's.
/// Test: load_test.
std::vector<Image> read_images(const Document& document, const Buffers& buffers,
                               const std::set<std::size_t>& to_decode);

/// Decodes image k, whose name is known.
/// Errors: BadScene.
void read_image(const Document& document, const Buffers& buffers, std::size_t k, Image& image);

}  // namespace mmverify::scene
