// The families' cases, changed so that a subject supports them.
#pragma once

#include <string>

#include "proofs/bake/domains/family.hpp"
#include "proofs/bake/support.hpp"

namespace mmverify::proofs::bake {

/// The families with as many cases, all of them supported.  An unsupported addressing mode is replaced by each
/// triangle turned over, mirrored and with its vertices in other orders.  Made once. Domain: families that last as
/// long as the program; their filter and their alpha mode are supported.
const Families& fitted(const Families& families, const Support& support);

}  // namespace mmverify::proofs::bake
