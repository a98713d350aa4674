// Bakes a map.
#pragma once

#include <cstdint>

#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::tests::foreign::bake {

/// 1; 0 where the case is not known, or is beyond what is supported here.
int bake(const mmverify_bake_case_t* what, std::uint8_t* map);

}  // namespace mmverify::tests::foreign::bake
