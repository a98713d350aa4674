// A folder of textures as a scene.
#include "scene/read/folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "scene/plan/plan.hpp"
#include "scene/read/bad_scene.hpp"
#include "tests/complaint.hpp"
#include "tests/scene/gltf_file.hpp"

namespace mmverify::scene {
namespace {

namespace fs = std::filesystem;

class SceneFolder : public testing::Test {
 protected:
  void SetUp() override {
    std::string made = (fs::temp_directory_path() / "texturesXXXXXX").string();
    ASSERT_NE(mkdtemp(made.data()), nullptr);
    folder_ = made;
  }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  std::string complaint() {
    return mmverify::tests::complaint_of<BadScene>([&] { load_textures(folder_.string()); }, "");
  }

  fs::path folder_;
};

TEST_F(SceneFolder, EachPictureIsASquareOfItsOwn) {
  write("b.PNG", tests::small_png());
  write("a.png", tests::small_png());
  write("notes.txt", "no picture");
  const Scene scene = load_textures(folder_.string());
  ASSERT_EQ(scene.images.size(), 2u);
  EXPECT_EQ(scene.images[0].name, "a.png");
  EXPECT_EQ(scene.images[1].name, "b.PNG");
  EXPECT_EQ(scene.images[0].width, 2u);
  const Plan planned = plan(scene);
  EXPECT_TRUE(planned.left_out.empty());
  EXPECT_EQ(planned.surfaces.size(), 2u);
  EXPECT_EQ(planned.triangles.size(), 4u);
  EXPECT_EQ(planned.surfaces[0].cutoff, 0.5f);
  EXPECT_EQ(scene.notes, std::vector<std::string>{"passed over: notes.txt"});
}

TEST_F(SceneFolder, WhatIsPassedOverIsNamed) {
  write("a.png", tests::small_png());
  EXPECT_TRUE(load_textures(folder_.string()).notes.empty());
  write("b.txt", "any");
  write("c.dds",
        "DDS |" + std::string(75, '\0') + "\4" + std::string(3, '\0') + "ABCD" + std::string(40, '\0'));
  fs::create_directory(folder_ / "d.png");
  const Scene scene = load_textures(folder_.string());
  EXPECT_EQ(scene.images.size(), 1u);
  EXPECT_EQ(scene.notes, std::vector<std::string>{
                             "passed over: b.txt, c.dds (a DDS of format 'ABCD' is not read here), d.png/"});
  for (int k = 10; k < 40; ++k) write("e" + std::to_string(k) + ".txt", "any");
  const std::string note = load_textures(folder_.string()).notes.at(0);
  EXPECT_NE(note.find("e26.txt and 13 more"), std::string::npos) << note;
}

TEST_F(SceneFolder, WhatIsWrongOfItIsNamed) {
  EXPECT_NE(
      complaint().find("no .png, .jpg, .jpeg, .webp, .avif, .dds, .ktx2, .tga or .exr that is read is in it"),
      std::string::npos)
      << complaint();
  write("cut.png", tests::small_png().substr(0, 40));
  EXPECT_NE(complaint().find("cut.png"), std::string::npos) << complaint();
  fs::remove_all(folder_);
  EXPECT_NE(complaint().find("No such file or directory"), std::string::npos) << complaint();
  fs::create_directory(folder_);
}

}  // namespace
}  // namespace mmverify::scene
