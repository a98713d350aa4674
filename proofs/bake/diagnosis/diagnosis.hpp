// Diagnosis of a refuted baker: the properties of cases that it gets wrong, and of those that it gets right.
#pragma once

#include <string>
#include <vector>

#include "proofs/bake/subject.hpp"

namespace mmverify::proofs::bake {

/// The kind of wrong states that a law is about.
enum class Fault : std::uint8_t { conservative, tight, side };

/// Lines such as "alpha filtered nearest: 98 of 130 cases wrong; all 120 bilinear ones right".  They sort some
/// hundred supported cases by each of their properties, and tell ties from states that are wrong on an area.  A last
/// line names the order of the micro-triangles if it is another known one.  Throws SubjectBroken.
std::vector<std::string> diagnose(const BakeSubject& subject, Fault fault);

}  // namespace mmverify::proofs::bake
