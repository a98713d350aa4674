// What is left of a level's micro-triangles once vertices have snapped: the few that changed, exactly.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/attribute/subject.hpp"
#include "proofs/engine/cases.hpp"

namespace mmverify::proofs::attribute {

/// A vertex and where its value is read from.
struct Move {
  Vertex from, to;
};

/// A micro-triangle with a corner that moved.
struct Changed {
  MicroTriangle of;
  Corners before, after;
};

/// Which vertices are asked for: all of a level, or those at most one step from a base edge, beside which all stay.
enum class Asked { all, at_edges };

/// Asks a subject for the vertices of a level, and finds the micro-triangles that changed.
class DecimatedMesh {
 public:
  /// Throws nothing of its own; what is wrong with the answers is complaint().
  DecimatedMesh(const AttributeSubject& subject, Level n, EdgeFlags flags, Asked asked);

  /// What is wrong whatever else holds: a vertex moved that is no odd one of a flagged edge, or left the triangle.
  const std::optional<Words>& complaint() const { return complaint_; }
  const std::vector<Move>& moves() const { return moves_; }
  const std::vector<Changed>& changed() const { return changed_; }
  std::uint64_t digest() const { return digest_; }

  Level level() const { return n_; }
  EdgeFlags flags() const { return flags_; }
  Vertex after(const Vertex& x) const;
  /// Whether a corner of it moved.
  bool has_changed(const MicroTriangle& t) const;

 private:
  void ask(const AttributeSubject& subject, std::span<const Vertex> at);

  Level n_;
  EdgeFlags flags_;
  std::optional<Words> complaint_;
  std::vector<Move> moves_;  ///< by number()
  std::vector<Changed> changed_;
  std::uint64_t digest_ = 0;
};

/// A number for each vertex of all levels up to 16, below 2^32.
constexpr std::uint64_t number(const Vertex& x) {
  return spec::attribute::w_minor_index<std::uint64_t>(x.i, x.j);
}

/// p N/2 for p flags, and 0 at level 0: odd vertices of flagged edges.
constexpr std::uint64_t odd_vertices(Level n, EdgeFlags flags) {
  const std::uint64_t p = (flags & 1) + (flags >> 1 & 1) + (flags >> 2 & 1);
  return n == 0 ? 0 : p * (spec::side(n) / 2);
}

/// What does not hold of it: edges of micro-triangles that meet in no opposite one, base edges that are no polyline of
/// level n-1 where flagged and n where not; areas; counts.  The finding's answer is the mesh's digest.
Finding watertight(const DecimatedMesh& mesh);
Finding areas_kept(const DecimatedMesh& mesh);
Finding counted(const DecimatedMesh& mesh);

/// Of the points of the triangle how many lie, if only the table of vertices is adjusted, in a micro-triangle that is
/// degenerate now or does not hold them any more; as an area in units of a micro-triangle, times 4.
std::uint64_t lost_quarters(const DecimatedMesh& mesh);

}  // namespace mmverify::proofs::attribute
