// The one place where entry points are called.
#pragma once

#include <cstdint>

#include "dock/desk/arguments.hpp"

namespace mmverify::dock {

/// Bytes of the answer: the size of an encoder's code, 0 for what was refused, otherwise a.room.
/// Domain: the subject has the entry point.
std::uint64_t call(const mmverify_subject_t& subject, Call entry, const Arguments& a);

}  // namespace mmverify::dock
