// Checks the description that a worker gives of its library.
#pragma once

#include <string>

#include "dock/mailbox.hpp"

namespace mmverify::dock {

/// What in it the header forbids, or nothing: "its max_level is above 16".
/// Domain: description_is_whole().
std::string description_fault(const Description& description);

/// Whether its texts end and its marks are 0 or 1.  A worker of ours writes no other one: something else wrote there.
bool description_is_whole(const Description& description);

}  // namespace mmverify::dock
