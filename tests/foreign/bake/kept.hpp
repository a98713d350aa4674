// Textures that a faulty baker has in mind from the case before.
#pragma once

#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::tests::foreign::bake {

/// The case; where a fault says so, with the texels of the last case that it takes for the same texture.
mmverify_bake_case_t with_kept_texels(const mmverify_bake_case_t& what);

}  // namespace mmverify::tests::foreign::bake
