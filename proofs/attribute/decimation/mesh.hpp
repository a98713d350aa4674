// The micro-triangles of a level that change once vertices have snapped, exactly.
#pragma once

#include "proofs/attribute/law_parts.hpp"
#include "proofs/attribute/laws.hpp"

namespace mmverify::proofs::attribute {

/// A vertex and the vertex that its value is read from.
struct Move {
  Vertex from, to;
};

/// A micro-triangle with a corner that moved.
struct Changed {
  MicroTriangle of;
  Corners before, after;
};

/// The vertices that a subject is asked for: all of a level, or those at most one step from a base edge.
enum class VertexChoice { all, at_edges };

/// Asks a subject for the vertices of a level, and finds the micro-triangles that changed.
class DecimatedMesh {
 public:
  /// Throws nothing of its own; what is wrong with the answers is complaint().
  DecimatedMesh(const AttributeSubject& subject, Level n, EdgeFlags flags, VertexChoice asked);

  /// A failure that ends every check: a vertex moved that is no odd one of a flagged edge, or left the triangle.
  const std::optional<Words>& complaint() const { return complaint_; }
  const std::vector<Move>& moves() const { return moves_; }
  const std::vector<Changed>& changed() const { return changed_; }
  std::uint64_t digest() const { return digest_; }

  Level level() const { return n_; }
  EdgeFlags flags() const { return flags_; }
  Vertex after(const Vertex& x) const;
  /// Whether a corner of the micro-triangle moved.
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

/// The number of odd vertices on flagged edges: p N/2 for p flags, and 0 at level 0.
constexpr std::uint64_t odd_vertices(Level n, EdgeFlags flags) {
  const std::uint64_t p = (flags & 1) + (flags >> 1 & 1) + (flags >> 2 & 1);
  return n == 0 ? 0 : p * (spec::side(n) / 2);
}

/// Checks of a mesh; the finding's answer is the mesh's digest.  watertight(): micro-triangle edges meet their
/// opposites, and base edges are polylines of level n-1 if flagged and of level n if not.  areas_kept(): areas.
/// counted(): numbers of degenerate micro-triangles and unused vertices.
Finding watertight(const DecimatedMesh& mesh);
Finding areas_kept(const DecimatedMesh& mesh);
Finding counted(const DecimatedMesh& mesh);

/// The area of the points that are lost if only the table of vertices is adjusted, as 4 times the number of
/// micro-triangles.  A point is lost if its micro-triangle is now degenerate or no longer holds it.
std::uint64_t lost_quarters(const DecimatedMesh& mesh);

extern const Entry snapped_entry, averaged_entry, place_entry;

/// Reads "flags=5".  Throws BadCase.
EdgeFlags flags_of_text(const std::string& text);

/// Laws of values at points, and on edges beside a neighbour.
std::vector<Law> decimated_value_laws();
/// The law of single vertices at high levels.
Law decimation_sample_law();
/// The law of neighbours two levels apart.
Law two_levels_law();

}  // namespace mmverify::proofs::attribute
