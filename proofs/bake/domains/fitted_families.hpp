// The families' cases within what a subject declares.
#pragma once

#include <string>

#include "proofs/bake/domains/family.hpp"
#include "proofs/bake/support.hpp"

namespace mmverify::proofs::bake {

/// Those families with as many cases, all of them supported: in the place of addressing modes that are not, each
/// triangle comes turned over, mirrored and with its vertices in other orders.  Made once.
/// Domain: families that last as long as the program; their filter and their alpha mode are supported.
const Families& fitted(const Families& families, const Support& support);

}  // namespace mmverify::proofs::bake
