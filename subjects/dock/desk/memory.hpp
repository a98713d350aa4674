// A worker's mapping of the shared memory.
#pragma once

#include <cstddef>

#include "subjects/dock/layout.hpp"

namespace mmverify::dock {

/// Maps the shared memory, with guard pages between the slots and read-only inputs; closes its descriptor.
/// Null if that fails.
std::byte* map(int fd, const Layout& layout);

/// From here on a wild access writes into the mailbox's message where it landed, and then the process
/// crashes.
/// Domain: called once; `base` is from map().
void explain_faults(std::byte* base, const Layout& layout);

/// The memory that the subject had for an earlier call, which a fault there is explained with; null: none.
void explain_taken_back(const std::byte* base, std::size_t bytes);

}  // namespace mmverify::dock
