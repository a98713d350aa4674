#include "scene/read/load.hpp"

#include <algorithm>
#include <set>

#include "scene/read/bad_scene.hpp"
#include "scene/read/extensions.hpp"
#include "scene/read/images.hpp"
#include "scene/read/materials.hpp"
#include "scene/read/nodes.hpp"
#include "scene/read/primitives.hpp"

namespace mmverify::scene {
namespace {

/// Calls take(texture) for each use of a texture whose alpha decides a state.
template <class Take>
void for_each_alpha_texture(const Scene& scene, const Take& take) {
  for (const Primitive& primitive : scene.primitives) {
    const Material& material = scene.material_of(primitive);
    if (!primitive.triangles.empty() && material.mode != AlphaMode::opaque && material.texture)
      take(*material.texture);
  }
}

/// The images whose alpha decides a state.
std::set<std::size_t> alpha_tested_images(const Scene& scene) {
  std::set<std::size_t> images;
  for_each_alpha_texture(scene, [&images](const BaseColorTexture& texture) {
    if (texture.image) images.insert(*texture.image);
  });
  return images;
}

/// The notes of the textures whose alpha decides a state, each once, and of the materials whose cutoff is above 1.
std::vector<std::string> notes_of(const Scene& scene) {
  std::vector<std::string> notes;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const Material& material = scene.materials[m];
    if (material.mode == AlphaMode::mask && material.cutoff > 1)
      notes.push_back(place("material", m, material.name) +
                      ": alphaCutoff is above 1: every texel is transparent");
  }
  for_each_alpha_texture(scene, [&notes](const BaseColorTexture& texture) {
    if (!texture.note.empty() && std::find(notes.begin(), notes.end(), texture.note) == notes.end())
      notes.push_back(texture.note);
  });
  return notes;
}

Scene scene_of(const Document& document) {
  const Buffers buffers(document);
  Scene scene;
  scene.file = document.file;
  scene.materials = read_materials(document, buffers);
  scene.meshes = read_meshes(document, buffers);
  scene.primitives = read_primitives(document, buffers, scene.materials);
  scene.notes = notes_of(scene);
  scene.images = read_images(document, buffers, alpha_tested_images(scene));
  return scene;
}

std::vector<MeshUse> uses_of(const Document& document) {
  const Buffers buffers(document);
  read_meshes(document, buffers);
  return read_uses(document, buffers);
}

}  // namespace

void decode_other_images(const Document& document, Scene& scene, std::uint64_t texels) {
  const Buffers buffers(document);
  for (std::size_t k = 0; k < scene.images.size(); ++k) {
    if (scene.images[k].decoded()) continue;
    Image image;
    image.name = scene.images[k].name;
    try {
      read_image(document, buffers, k, image);
    } catch (const BadScene&) {
      continue;
    }
    const std::uint64_t size = std::uint64_t{image.width} * image.height;
    if (size > texels) return;
    texels -= size;
    scene.images[k] = std::move(image);
  }
}

std::vector<MeshUse> load_uses(const std::string& file) { return uses_of(open_document(file)); }

std::vector<MeshUse> load_uses(const std::string& name, std::span<const unsigned char> bytes) {
  return uses_of(open_document(name, bytes));
}

Scene load(const Document& document) { return scene_of(document); }

Scene load(const std::string& file) { return scene_of(open_document(file)); }

Scene load(const std::string& name, std::span<const unsigned char> bytes) {
  return scene_of(open_document(name, bytes));
}

}  // namespace mmverify::scene
