// What a baker of attributes says that it supports: cases are drawn inside it.  mmverify_attribute_support in the C
// header.
#pragma once

#include <cstdint>
#include <string>

#include "proofs/attribute/subject.hpp"

namespace mmverify::proofs::attribute {

/// Whether fitted() leaves the case as it is.
bool covers(const BakingSupport& support, const BakeCase& one);

/// The case with each setting that is not supported exchanged for one that is; which of several, its coordinates say.
BakeCase fitted(const BakingSupport& support, BakeCase one);

/// The same by a subject's support.
inline BakeCase fitted_case(const AttributeSubject& s, const BakeCase& one) {
  return fitted(s.functions.baking.support, one);
}

/// "linear and srgb; clamp; within 1 code": what is not as it is of one that says nothing; empty: nothing.
std::string text_of(const BakingSupport& support);

}  // namespace mmverify::proofs::attribute
