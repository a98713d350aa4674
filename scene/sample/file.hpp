// A glTF file that is put together piece by piece.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "scene/scene.hpp"
#include "scene/write/container.hpp"

namespace mmverify::scene {

/// Vertices of a primitive, and the order in which it draws them.
struct SampleMesh {
  std::vector<Position> positions;
  std::vector<Uv> uvs;
  std::vector<std::uint16_t> indices;  ///< empty: as they come

  /// Corners in order around a quad: two triangles that share the edge from the first to the third.
  void add_quad(const std::array<Position, 4>& corners, const std::array<Uv, 4>& quad_uvs);
};

class SampleFile {
 public:
  nlohmann::json json = {{"asset", {{"version", "2.0"}, {"generator", "mmverify"}}}, {"scene", 0}};

  /// Appends to an array of the root, and returns the number.
  std::size_t add(const char* array, nlohmann::json element);

  /// An accessor of float vectors, tightly packed; positions get their bounds, as glTF wants.
  template <std::size_t N>
  std::size_t add_vectors(const std::vector<std::array<float, N>>& values, bool bounds = false,
                          bool of_vertices = true);
  std::size_t add_numbers(const std::vector<float>& values, bool bounds);

  /// A primitive of the mesh, mode 4; `small`: indices of 8 bits.
  nlohmann::json primitive(const SampleMesh& mesh, std::size_t material, bool small = false);

  std::size_t add_image(const std::string& name, std::span<const unsigned char> png);

  /// A node of the scene; `at` is its translation.
  std::size_t place(std::size_t mesh, const char* name, const Position& at, float scale = 1);

  Bytes finished() { return glb(std::move(json), binary_); }

 private:
  BinaryChunk binary_{json};
};

}  // namespace mmverify::scene
