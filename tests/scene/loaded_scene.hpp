// glTF files made by a test, loaded: what is read, and what is said of one that cannot be read.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene/read/bad_scene.hpp"
#include "scene/read/load.hpp"
#include "scene/read/triangles.hpp"
#include "tests/folder.hpp"
#include "tests/scene/gltf_file.hpp"

namespace mmverify::tests {

using namespace mmverify::scene;

/// Writes the content as a file and loads it.
inline Scene load_text(const std::string& content, const std::string& name = "leaf.gltf") {
  const Folder folder;
  GltfFile::write(folder / name, content);
  return load(folder / name);
}

inline Scene load_glb(GltfFile file) {
  file.set_buffer_length();
  return load_text(file.glb(), "leaf.glb");
}

/// The error's text after the folder; the loading must fail.
inline std::string complaint(const std::string& content, const std::string& name = "leaf.glb") {
  const Folder folder;
  GltfFile::write(folder / name, content);
  try {
    load(folder / name);
  } catch (const BadScene& bad) {
    const std::string what = bad.what(), start = folder.path().string() + "/";
    EXPECT_TRUE(what.starts_with(start + name + ": ")) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    return what.substr(start.size());
  }
  ADD_FAILURE() << "loaded";
  return "";
}

inline std::string complaint(const GltfFile& file) { return complaint(file.glb()); }

inline std::vector<std::uint8_t> alpha8(const Image& image) { return std::get<0>(image.alpha); }
inline std::vector<std::uint16_t> alpha16(const Image& image) { return std::get<1>(image.alpha); }

inline GltfFile with_image(const std::string& bytes) {
  GltfFile file = square();
  file.json["images"][0]["bufferView"] = file.add_view(bytes);
  file.set_buffer_length();
  return file;
}

inline void expect_square(const Scene& scene) {
  ASSERT_EQ(scene.primitives.size(), 1u);
  const Primitive& primitive = scene.primitives[0];
  EXPECT_THAT(primitive.triangles, testing::ElementsAre(Triangle{0, 1, 2}, Triangle{0, 2, 3}));
  EXPECT_THAT(primitive.positions, testing::ElementsAre(Position{0, 0, 0}, Position{1, 0, 0},
                                                        Position{1, 1, 0}, Position{0, 1, 0}));
  EXPECT_THAT(primitive.uvs, testing::ElementsAre(Uv{0, 1}, Uv{1, 1}, Uv{1, 0}, Uv{0, 0}));
  ASSERT_EQ(scene.images.size(), 1u);
  EXPECT_EQ(scene.images[0].width, 2u);
  EXPECT_EQ(scene.images[0].height, 2u);
  EXPECT_EQ(alpha8(scene.images[0]), (std::vector<std::uint8_t>{0, 85, 170, 255}));
  EXPECT_EQ(scene.meshes.at(0).uses, 1u);
  const Material& material = scene.material_of(primitive);
  EXPECT_EQ(material.name, "leaf");
  EXPECT_EQ(material.mode, AlphaMode::mask);
  EXPECT_EQ(material.cutoff, 0.5f);
  EXPECT_EQ(material.base_color_alpha, 1);
}

}  // namespace mmverify::tests
