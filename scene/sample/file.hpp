// A glTF file that is built piece by piece.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "scene/scene.hpp"
#include "scene/write/container.hpp"

namespace mmverify::scene {

/// The vertices of a primitive, and the order in which it draws them.
struct SampleMesh {
  std::vector<Position> positions;
  std::vector<Uv> uvs;
  std::vector<std::uint16_t> indices;  ///< empty: vertices in their order

  /// Adds a quad from its corners in order around it: two triangles that share the edge from the first to the
  /// third.
  void add_quad(const std::array<Position, 4>& corners, const std::array<Uv, 4>& quad_uvs);
};

class SampleFile {
 public:
  nlohmann::json json = {{"asset", {{"version", "2.0"}, {"generator", "mmverify"}}}, {"scene", 0}};

  /// Appends an element to an array of the root, and returns its number.
  std::size_t add(const char* array, nlohmann::json element);

  /// Adds an accessor of float vectors, tightly packed, and returns its number.  `bounds` adds min and max,
  /// which glTF requires of positions.
  template <std::size_t N>
  std::size_t add_vectors(const std::vector<std::array<float, N>>& values, bool bounds = false,
                          bool of_vertices = true);
  std::size_t add_numbers(const std::vector<float>& values, bool bounds);

  /// A primitive of the mesh, mode 4; `small`: indices of 8 bits.
  nlohmann::json primitive(const SampleMesh& mesh, std::size_t material, bool small = false);

  std::size_t add_image(const std::string& name, std::span<const unsigned char> png);

  /// Adds a node to the scene; `at` is its translation.
  std::size_t place(std::size_t mesh, const char* name, const Position& at, float scale = 1);

  Bytes finished() { return glb(std::move(json), binary_); }

 private:
  BinaryChunk binary_{json};
};

}  // namespace mmverify::scene
