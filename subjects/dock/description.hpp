// Checks a worker's description of its library.
#pragma once

#include <string>

#include "subjects/dock/mailbox.hpp"

namespace mmverify::dock {

/// The first fault that the header forbids, such as "its max_level is above 16"; empty if there is none.
/// Domain: description_is_whole().
std::string description_fault(const Description& description);

/// Whether its texts are terminated and its flags are 0 or 1. Our worker writes no other description:
/// something else overwrote it.
bool description_is_whole(const Description& description);

}  // namespace mmverify::dock
