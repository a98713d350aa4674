// Writes GLBs into a folder, for Khronos's validator to read: the sample scene, and scenes with micromaps.
//   written_scenes FOLDER SCENE...       the micromaps say nothing true; their form is what is looked at
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "scene/read/load.hpp"
#include "scene/sample/scene.hpp"
#include "scene/write/glb.hpp"

namespace {

using namespace mmverify::scene;
namespace micromap = mmverify::impl::micromap;

/// Every primitive with triangles gets some, in one encoding after the other.
struct Invented {
  micromap::Array array{{{0, 2, 2}, {4, 1, 1}, {5, 3, 1}}, micromap::Bytes(13, 0x5a)};
  std::vector<micromap::Bytes> indices;
  std::vector<PrimitiveMicromaps> primitives;

  explicit Invented(const Scene& scene) {
    using enum micromap::Encoding;
    constexpr micromap::Encoding encodings[] = {u32, u16, i16, u8};
    indices.reserve(scene.primitives.size());
    for (const Primitive& primitive : scene.primitives) {
      if (primitive.triangles.empty()) continue;
      const micromap::Encoding encoding = encodings[indices.size() % std::size(encodings)];
      const std::size_t size = micromap::width(encoding) / 8;
      // All special, but for every third.
      micromap::Bytes& bytes = indices.emplace_back(primitive.triangles.size() * size, 0xff);
      for (std::size_t t = 0; t < primitive.triangles.size(); t += 3)
        for (std::size_t k = 0; k < size; ++k) bytes[t * size + k] = k == 0 ? t % 2 : 0;
      primitives.push_back({primitive.mesh, primitive.number, 0, encoding, bytes, 1});
    }
  }
  Micromaps micromaps() const { return {std::span(&array, 1), primitives}; }
};

void write(const std::filesystem::path& file, const Bytes& bytes) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!out.flush()) throw std::runtime_error(file.string() + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 2) throw std::runtime_error("usage: written_scenes FOLDER SCENE...");
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    const Bytes sample = sample_scene();
    write(folder / "sample.glb", sample);
    write(folder / "sample_micromaps.glb",
          to_glb("sample.glb", sample, Invented(load("sample.glb", sample)).micromaps()));
    for (int k = 2; k < argc; ++k) {
      const std::filesystem::path file = argv[k];
      write(folder / (file.stem().string() + ".glb"), to_glb(file, Invented(load(file)).micromaps()));
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "written_scenes: %s\n", error.what());
    return 1;
  }
}
