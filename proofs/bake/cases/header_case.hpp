// A case in the form of the C header of subjects.
#pragma once

#include "proofs/bake/cases/case.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::proofs::bake {

/// The case's struct; level and format are the caller's, and so is the place of the texels.
mmverify_bake_case_t header_case(const Case& one, Level n, std::uint32_t format);

/// The texels as the header stores them, in the machine's byte order.
std::vector<std::uint8_t> header_texels(const Case& one);

}  // namespace mmverify::proofs::bake
