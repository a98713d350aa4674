// The record whose level or format is the likely fault of an array that breaks rules.
#pragma once

#include <string>

#include "impl/micromap/validate.hpp"

namespace mmverify::scene {

/// "suspect: record 3: it says level 5 in 4-state (256 bytes), and has the 16 bytes of level 3 in 4-state", and the number of
/// further ones; empty if no other levels and formats fill the bytes from each map's first to the next one's.
///   - Offsets are the suspects, and no level, if maps of these levels, one after another, fill the data.
///   - Maps that leave gaps, and share no byte, are suspects only if the usage counts are those of the other levels.
/// Domain: any input; records 8 bytes apart, else empty.
/// Test: SuspectRecord (edit_test)
std::string suspect_record(const impl::micromap::Input& in);

}  // namespace mmverify::scene
