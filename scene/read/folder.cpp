#include "scene/read/folder.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <vector>

#include "scene/read/bad_scene.hpp"
#include "scene/read/file.hpp"
#include "scene/read/image.hpp"

namespace mmverify::scene {
namespace {

namespace fs = std::filesystem;

bool is_picture(const fs::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

Primitive square(std::size_t mesh, std::size_t material) {
  Primitive p;
  p.mesh = mesh;
  p.material = material;
  p.triangles = {{0, 1, 2}, {3, 2, 1}};
  p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  p.uvs = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  return p;
}

}  // namespace

Scene load_textures(const std::string& folder) {
  std::vector<fs::path> pictures;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (is_picture(it->path())) pictures.push_back(it->path());
  if (error) throw BadScene(folder, "the folder", error.message());
  if (pictures.empty()) throw BadScene(folder, "the folder", "no .png, .jpg or .jpeg is in it");
  std::sort(pictures.begin(), pictures.end());
  Scene scene;
  scene.file = folder;
  for (const fs::path& path : pictures) {
    const std::size_t k = scene.images.size();
    Image image;
    image.name = path.filename().string();
    decode_alpha(read_file(path, folder, image.name), image, folder, image.name);
    scene.images.push_back(std::move(image));
    Material material;
    material.name = path.filename().string();
    material.mode = AlphaMode::mask;
    material.texture =
        BaseColorTexture{k, 0, Sampler{Wrap::repeat, Wrap::repeat, Filter::linear, {}, {}}, {}};
    scene.materials.push_back(std::move(material));
    Mesh mesh;
    mesh.name = path.filename().string();
    mesh.uses = 1;
    mesh.placements.similar = 1;
    scene.meshes.push_back(std::move(mesh));
    scene.primitives.push_back(square(k, k));
  }
  return scene;
}

}  // namespace mmverify::scene
