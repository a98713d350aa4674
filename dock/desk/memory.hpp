// A worker process's view of the shared memory.
#pragma once

#include <cstddef>

#include "dock/layout.hpp"

namespace mmverify::dock {

/// Maps the shared memory with nothing between the slots, and inputs that cannot be written; closes its descriptor.
/// Null where that fails.
std::byte* map(int fd, const Layout& layout);

/// From here on a wild access says in the mailbox's message where it landed, then lets the crash happen.
/// Domain: called once; base is map()'s.
void explain_faults(std::byte* base, const Layout& layout);

}  // namespace mmverify::dock
