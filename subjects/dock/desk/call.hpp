// Calls entry points; no other file does.
#pragma once

#include <cstdint>

#include "subjects/dock/desk/arguments.hpp"

namespace mmverify::dock {

/// Calls an entry point. Returns the bytes of the answer: the size of an encoder's code, 0 for a refusal,
/// otherwise a.room.
/// Domain: the subject has the entry point.
std::uint64_t call(const mmverify_subject_t& subject, Call entry, const Arguments& a);

}  // namespace mmverify::dock
