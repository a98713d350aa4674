// Attribute micromaps by another hand.
#pragma once

#include <string>

#include "proofs/attribute/subject.hpp"

namespace mmverify::tests::foreign::attribute {

/// The subject with that row of attribute_faults.def; the right one where the name is empty.
/// Errors: std::invalid_argument where the name is no row's.
proofs::attribute::AttributeSubjectPtr subject_with(const std::string& fault);

}  // namespace mmverify::tests::foreign::attribute
