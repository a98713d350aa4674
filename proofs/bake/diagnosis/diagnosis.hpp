// Diagnosis of a refuted baker: the properties of cases that it gets wrong, and of those that it gets right.
#pragma once

#include "proofs/bake/cases/case.hpp"
#include "proofs/bake/subject.hpp"
#include "proofs/bake/truth/offender.hpp"

namespace mmverify::proofs::bake {

/// The kind of wrong states that a law is about.
enum class Fault : std::uint8_t { conservative, tight, side };

/// Lines such as "alpha filtered nearest: 98 of 130 cases wrong; all 120 bilinear ones right".  They sort some
/// hundred supported cases by each of their properties, and tell ties from states that are wrong on an area.  A last
/// line names the order of the micro-triangles if it is another known one.  Throws SubjectBroken.
std::vector<std::string> diagnose(const BakeSubject& subject, Fault fault);

/// The name of the order if it is a known one other than the curve's, else empty.  It bakes one map for each
/// micro-triangle of level n, from a texture that is transparent except for a dot inside that micro-triangle. Domain:
/// n in 1..4.  Throws SubjectBroken.
std::string order_of(const BakeSubject& subject, Level n);

struct Property {
  const char* of;     ///< "filter"
  std::string value;  ///< "nearest"
};

/// Filter, addressing along u and v, sizes, signs of texture coordinates, kind of triangle, texels, alpha mode, mips,
/// factors and margin, the same ones in the same order of every case.
std::vector<Property> properties_of(const Case& one, Level n);

struct KnownMistake {
  const char* as_if;  ///< "rows of texels came from below"
  void (*mistake)(Case&);
};

/// Each leaves some cases as they are.
const std::vector<KnownMistake>& known_mistakes();

/// An SVG: the texels around the worst micro-triangle, or around the base triangle where all are right; its
/// outline; the line where alpha is at its threshold; the point that contradicts the state.
std::string picture(const Case& one, Level n, const std::optional<Offender>& offender);

}  // namespace mmverify::proofs::bake
