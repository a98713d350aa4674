#include "scene/read/folder.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <vector>

#include "scene/read/bad_scene.hpp"
#include "scene/read/file.hpp"
#include "scene/read/image.hpp"
#include "scene/read/picture_kind.hpp"

namespace mmverify::scene {
namespace {

namespace fs = std::filesystem;

bool is_picture(const fs::path& path) {
  constexpr std::string_view endings[] = {".png", ".jpg",  ".jpeg", ".webp", ".avif",
                                          ".dds", ".ktx2", ".tga",  ".exr"};
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::find(std::begin(endings), std::end(endings), ending) != std::end(endings);
}

bool is_gltf(const fs::path& path) { return path.extension() == ".gltf" || path.extension() == ".glb"; }

/// A list of names for a message.
class PassedOver {
 public:
  void add(const std::string& name) {
    if (++count_ <= most) text_ += (text_.empty() ? "" : ", ") + shown(name);
  }
  std::string text() const {
    return text_ + (count_ > most ? " and " + std::to_string(count_ - most) + " more" : "");
  }
  bool empty() const { return count_ == 0; }

 private:
  static constexpr std::size_t most = 20;
  std::string text_;
  std::size_t count_ = 0;
};

Primitive square(std::size_t mesh, std::size_t material) {
  Primitive p;
  p.mesh = mesh;
  p.material = material;
  p.triangles = {{0, 1, 2}, {3, 2, 1}};
  p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  p.uvs = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  return p;
}

/// Adds a picture on a square of its own.
void add(Scene& scene, Image image) {
  const std::size_t k = scene.images.size();
  Material material;
  material.name = image.name;
  material.mode = AlphaMode::mask;
  material.texture = BaseColorTexture{k, 0, Sampler{Wrap::repeat, Wrap::repeat, Filter::linear, {}, {}}, {}};
  scene.materials.push_back(std::move(material));
  Mesh mesh;
  mesh.name = image.name;
  mesh.uses = 1;
  mesh.placements.similar = 1;
  scene.meshes.push_back(std::move(mesh));
  scene.primitives.push_back(square(k, k));
  scene.images.push_back(std::move(image));
}

}  // namespace

Scene load_textures(const std::string& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    entries.push_back(it->path());
  if (error) throw BadScene(folder, "the folder", error.message());
  std::sort(entries.begin(), entries.end());
  Scene scene;
  scene.file = folder;
  PassedOver passed_over;
  std::string scene_file;
  for (const fs::path& path : entries) {
    Image image;
    image.name = path.filename().string();
    if (!is_picture(path) || fs::is_directory(path, error)) {
      if (is_gltf(path) && scene_file.empty()) scene_file = path.string();
      passed_over.add(image.name + (fs::is_directory(path, error) ? "/" : ""));
      continue;
    }
    const Bytes bytes = read_file(path, folder, image.name);
    if (const auto why = why_unread(bytes, PictureUse::alpha)) {
      passed_over.add(image.name + " (" + *why + ")");
      continue;
    }
    decode_alpha(bytes, image, folder, image.name);
    add(scene, std::move(image));
  }
  const std::string over = passed_over.empty() ? "" : "passed over: " + passed_over.text();
  if (scene.images.empty())
    throw BadScene(folder, "the folder",
                   "no .png, .jpg, .jpeg, .webp, .avif, .dds, .ktx2, .tga or .exr that is read is in it" +
                       (over.empty() ? "" : "; " + over) +
                       (scene_file.empty() ? "" : "; a scene is named by its file: " + scene_file));
  if (!over.empty()) scene.notes.push_back(over);
  if (!scene_file.empty())
    scene.notes.push_back("these are the folder's pictures; its scene is named by its file: " + scene_file);
  return scene;
}

}  // namespace mmverify::scene
