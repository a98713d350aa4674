// A case of a baker of meshes: triangles on one texture, and the array that is wanted.
#pragma once

#include "proofs/array/subject.hpp"
#include "proofs/bake/support.hpp"

namespace mmverify::proofs::bake {

struct MeshCase {
  Case surface;  ///< the texture and its sampling; its own coordinates do not count
  spec::micromap::Format format = spec::micromap::Format::four_state;
  array::Api api = array::Api::KHR;
  array::Encoding encoding = array::Encoding::u32;
  std::vector<std::array<float, 2>> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  Level level = 0;                 ///< of all triangles, if `levels` is empty
  std::vector<Level> levels = {};  ///< of each triangle

  Level level_of(std::size_t triangle) const { return levels.empty() ? level : levels[triangle]; }
  friend bool operator==(const MeshCase&, const MeshCase&) = default;
};

/// The surface with one triangle's coordinates.
Case on_triangle(const MeshCase& mesh, std::size_t triangle);

/// The mesh of one triangle alone, with vertices of its own.
MeshCase alone(const MeshCase& mesh, std::size_t triangle);

/// The case as an array that is to be built: its options, and as many maps as triangles, without states.
array::BuildCase build_case(const MeshCase& mesh);

/// The surface as text_of(Case) has it, then
/// "api=khr,indices=u16,format=4,vertices=U:V:U:V:...,triangles=0:1:2:...,levels=3:0"; without levels all have the case's.
std::string text_of(const MeshCase& mesh);
/// The case of a text, at level n.  Throws BadCase.
MeshCase mesh_from(const std::string& text, Level n);

/// Changes the mesh to one that the subject supports, by the rules that it declares.  Coordinates beyond what it
/// declares are reflected into it, so that equal ones stay equal, and near ones near.
MeshCase fitted(const Support& support, MeshCase mesh, std::uint64_t salt);

}  // namespace mmverify::proofs::bake
