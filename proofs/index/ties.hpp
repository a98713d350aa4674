// The rule of ties that a wrong index breaks: which micro-triangle a point on an edge belongs to.
#pragma once

#include <string>

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// "the rule: where uf + vf = 1 the upper micro-triangle owns the point, so test uf + vf >= 1": the rules of the kinds of
/// edges on which the subject is wrong; empty if it is wrong on no edge within the base triangle.  uf and vf are the
/// fractional parts of 2^n u and 2^n v.
/// Source: Vulkan's appendix on opacity micromaps, whose floor and comparison these are; docs/INDEX.md.
/// Domain: n at most 7 and the subject's highest level; a subject that has the curve's entry point.
/// Test: IndexDiagnosis.NamesTheRuleOfWrongTies (index_dialect_test)
std::string rule_of_ties(const IndexSubject& subject, Level n);

}  // namespace mmverify::proofs::index
