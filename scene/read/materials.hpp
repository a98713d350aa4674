// A reader of a document's materials, textures and samplers.
#pragma once

#include <vector>

#include "scene/read/buffers.hpp"
#include "scene/read/picture_kind.hpp"
#include "scene/scene.hpp"

namespace mmverify::scene {

/// All materials, with the animations that change them.
/// Errors: BadScene if an alphaMode, filter or wrap mode is none of glTF's, or alphaCutoff or
/// baseColorFactor's alpha is out of range (0 <= cutoff; 0 <= alpha <= 1), and as of read_texture().
std::vector<Material> read_materials(const Document& document, const Buffers& buffers);

/// The texture that a textureInfo of the JSON names, with KHR_texture_transform; `at` is the material, for
/// messages.
/// `use`: what of its image is to be read, which decides between images.
/// Errors: BadScene for a filter or wrap mode that is none of glTF's, and as of texture_source().
BaseColorTexture read_texture(const Document& document, const Buffers& buffers, const nlohmann::json& info,
                              PictureUse use, const std::string& at);

}  // namespace mmverify::scene
