// The mips of a case.
#pragma once

#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/foreign/bake/field.hpp"

namespace mmverify::tests::foreign::bake {

std::vector<Mip> mips_of(const mmverify_bake_case_t& c);

}  // namespace mmverify::tests::foreign::bake
