// How much memory was asked for at once.
#pragma once

#include <atomic>
#include <cstddef>

namespace mmverify::tests {

/// The largest request of operator new since this was last set to 0, in bytes.  Needs
/// largest_allocation.cpp in the program.
extern std::atomic<std::size_t> largest_allocation;

}  // namespace mmverify::tests
