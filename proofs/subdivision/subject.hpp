// A subject of topic subdivision: functions that give the cell of a point and the corners of a cell, built in or in the dock.
#pragma once

#include "proofs/engine/topic.hpp"
#include "spec/subdivision/tetrahedra.hpp"

namespace mmverify::proofs::subdivision {

using spec::subdivision::all_schemes;
using spec::subdivision::At;
using spec::subdivision::Corners;
using spec::subdivision::Cut;
using spec::subdivision::cut;
using spec::subdivision::determinant;
using spec::subdivision::Diagonal;
using spec::subdivision::difference;
using spec::subdivision::Scheme;
using spec::subdivision::Tetrahedron;
using Whole = std::int64_t;

/// Coordinates as fractions of one denominator.
struct Fractions {
  std::array<std::uint32_t, 3> numerators;
  std::uint32_t denominator;
};

/// An orientation of cells, as a state machine has it: the corners around the first one; for each digit the first corner of
/// the child, around the parent's first one times `scale`, and the child's orientation.
struct Orientation {
  Corners<Whole> corners;
  Whole scale;
  std::vector<At<Whole>> shift;
  std::vector<std::size_t> next;
};
/// The orientations of a scheme, the unit shape's first.
using Machine = std::vector<Orientation>;

/// The entry points of a subject; an empty function is a missing entry point.  Several threads may call at once.
struct Functions {
  static constexpr char topic[] = "subdivision";
  Level max_level = 16;  ///< of the laws; the bisection goes to twice that and one
  /// Domain: a point of the closed unit shape.
  std::function<std::uint64_t(Scheme, Level, const Fractions&)> index = {};
  /// The corners on the grid of side(scheme, level).  Domain: an index of the level.
  std::function<Corners<Whole>(Scheme, Level, std::uint64_t)> corners = {};
  std::function<Machine(Scheme)> machine = {};
  /// The number of shapes on levels up to one.
  std::function<std::size_t(const Tetrahedron&, Diagonal, Level)> shapes = {};
  /// The laws ask for fractions of whole numbers, and mean those.
  bool exact_answers() const { return true; }
};

using Entry = EntryOf<Functions>;
namespace entry {
inline constexpr Entry index{"subdivision_index", [](const Functions& f) { return bool{f.index}; }};
inline constexpr Entry corners{"subdivision_corners", [](const Functions& f) { return bool{f.corners}; }};
inline constexpr Entry machine{"machine", [](const Functions& f) { return bool{f.machine}; }};
inline constexpr Entry shapes{"shapes", [](const Functions& f) { return bool{f.shapes}; }};
}  // namespace entry

using SubdivisionSubject = SubjectOf<Functions>;
using SubdivisionSubjectPtr = std::shared_ptr<const SubdivisionSubject>;

/// The specification on whole numbers, subdivision-spec, and on rationals, subdivision-rational; the library, subdivision.
const std::vector<SubdivisionSubjectPtr>& built_in_subjects();

/// The subject that a library offers; null where it has no entry point of this topic.
SubdivisionSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::subdivision
