// The support that a baker of attributes declares; cases are drawn inside it.  In the C header:
// mmverify_attribute_support.
#pragma once

#include <cstdint>
#include <string>

#include "proofs/attribute/subject.hpp"

namespace mmverify::proofs::attribute {

/// Whether fitted() leaves the case as it is.
bool covers(const BakingSupport& support, const BakeCase& one);

/// The case with each unsupported setting replaced by a supported one, chosen by the case's coordinates.
BakeCase fitted(const BakingSupport& support, BakeCase one);

/// The case fitted to a subject's support.
inline BakeCase fitted_case(const AttributeSubject& s, const BakeCase& one) {
  return fitted(s.functions.baking.support, one);
}

/// The restrictions as text, "linear and srgb; clamp; within 1 code"; empty if there are none.
std::string text_of(const BakingSupport& support);

}  // namespace mmverify::proofs::attribute
