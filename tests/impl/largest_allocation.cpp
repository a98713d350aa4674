// This file stands alone: compilers warn of a mismatch where they inline one of our new and delete.
#include "tests/impl/largest_allocation.hpp"

#include <cstdlib>
#include <new>

namespace mmverify::tests {
std::atomic<std::size_t> largest_allocation{0};
}

void* operator new(std::size_t size) {
  std::atomic<std::size_t>& largest = mmverify::tests::largest_allocation;
  std::size_t before = largest;
  while (before < size && !largest.compare_exchange_weak(before, size)) continue;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
