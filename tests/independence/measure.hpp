// Counts what a law's questions vary: each field alone, and each pair of bits.
#pragma once

#include "tests/independence/regions.hpp"

namespace mmverify::independence {

/// Whether MMVERIFY_MEASURE names a file.
bool measures();

/// Counts a question and its right answer in that file, whose layout scripts/independence has; the names of fields and bits
/// go to the file of that name with ".names" behind it.
void measure(dock::Call entry, const Regions& question, const Region& answer);

}  // namespace mmverify::independence
