// What a baker that was refuted does wrong, and what it does right.
#pragma once

#include <string>
#include <vector>

#include "proofs/bake/subject.hpp"

namespace mmverify::proofs::bake {

/// Which states a law is about.
enum class Fault : std::uint8_t { conservative, tight, side };

/// Lines such as "alpha filtered nearest: 98 of 130 cases wrong; all 120 bilinear ones right": of some hundred cases
/// within what the subject declares, by each of their properties; ties apart from states that are wrong on an area;
/// and the order of the micro-triangles, if it is another known one.
/// Throws SubjectBroken.
std::vector<std::string> diagnose(const BakeSubject& subject, Fault fault);

}  // namespace mmverify::proofs::bake
