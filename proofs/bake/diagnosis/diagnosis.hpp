// Diagnosis of a refuted baker: the properties of cases that it gets wrong, and of those that it gets right.
#pragma once

#include "proofs/bake/cases/case.hpp"
#include "proofs/bake/subject.hpp"
#include "proofs/bake/truth/offender.hpp"

namespace mmverify::proofs::bake {

/// The kind of wrong states that a law is about.
enum class Fault : std::uint8_t { conservative, tight, side };

/// Lines such as "alpha filtered nearest: 98 of 130 cases wrong; all 120 bilinear ones right".  The diagnosis runs a
/// few hundred cases that the baker supports, sorts them by each property, and separates ties from states that are
/// wrong on an area.  If the baker's micro-triangles follow another known order, the last line names it.  Throws
/// SubjectBroken.
std::vector<std::string> diagnose(const BakeSubject& subject, Fault fault);

/// The name of the baker's order of micro-triangles; empty for the curve's order, or an unknown one.  For each
/// micro-triangle of level n the baker bakes a texture that is transparent except for a dot inside that micro-triangle.
/// Domain: n in 1..4.  Throws SubjectBroken.
std::string order_of(const BakeSubject& subject, Level n);

struct Property {
  const char* of;     ///< "filter"
  std::string value;  ///< "nearest"
};

/// A case's filter, addressing along u and v, sizes, signs of texture coordinates, kind of triangle, texels, alpha
/// mode, mips, factors and margin.  Every case has the same list of properties, in the same order.
std::vector<Property> properties_of(const Case& one, Level n);

struct KnownMistake {
  const char* as_if;  ///< "rows of texels came from below"
  void (*mistake)(Case&);
  std::array<State, 4> states{State::T, State::O, State::UT,
                              State::UO};  ///< the state written for each, by code
};

/// The mistakes that a diagnosis can name.  Each changes some cases, and leaves others as they are.
const std::vector<KnownMistake>& known_mistakes();

/// An SVG: the texels around the worst micro-triangle, or around the base triangle where all are right; its
/// outline; the line where alpha is at its threshold; the point that contradicts the state.
std::string picture(const Case& one, Level n, const std::optional<Offender>& offender);

}  // namespace mmverify::proofs::bake
