// A reader of a document's materials, textures and samplers.
#pragma once

#include <vector>

#include "scene/read/document.hpp"
#include "scene/scene.hpp"

namespace mmverify::scene {

/// All materials, with the animations that change them.
/// Errors: BadScene if an alphaMode, filter or wrap mode is none of glTF's, or alphaCutoff or
/// baseColorFactor's alpha is out of range (0 <= cutoff; 0 <= alpha <= 1).
std::vector<Material> read_materials(const Document& document);

/// The texture that a textureInfo of the JSON names, with KHR_texture_transform; `at` is the material, for
/// messages.
/// Errors: BadScene for a filter or wrap mode that is none of glTF's.
BaseColorTexture read_texture(const Document& document, const nlohmann::json& info, const std::string& at);

}  // namespace mmverify::scene
