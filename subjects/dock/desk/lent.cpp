#include "subjects/dock/desk/lent.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <new>

#include "subjects/dock/desk/memory.hpp"

namespace mmverify::dock {
namespace {

/// A mapping at a free address of the wanted ones, or null.
std::byte* map_from(std::uintptr_t first, std::size_t bytes) {
#ifdef MAP_FIXED_NOREPLACE
  constexpr std::uintptr_t step = std::uintptr_t{1} << 26;
  constexpr unsigned tries = 8;
  for (unsigned k = 0; k < tries; ++k) {
    void* const wanted = reinterpret_cast<void*>(first + k * step);
    void* const got =
        mmap(wanted, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED_NOREPLACE, -1, 0);
    if (got == wanted) return static_cast<std::byte*>(got);
    // Kernels before 4.17 take the address for a hint.
    if (got != MAP_FAILED) munmap(got, bytes);
  }
#endif
  (void)first, (void)bytes;
  return nullptr;
}

std::byte* map_memory(std::size_t bytes, Lent::Where where) {
  constexpr std::uintptr_t below_2_gib = 0x30000000, below_4_gib = 0xC0000000;
  std::byte* got = nullptr;
  if (where == Lent::Where::below_2_gib) got = map_from(below_2_gib, bytes);
  if (where == Lent::Where::below_4_gib) got = map_from(below_4_gib, bytes);
  if (got != nullptr) return got;
  void* const any = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (any == MAP_FAILED) throw std::bad_alloc();
  return static_cast<std::byte*>(any);
}

}  // namespace

Lent::Lent(const std::vector<std::size_t>& sizes, Where where) {
  static const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const auto rounded = [](std::size_t bytes) { return (bytes + page - 1) / page * page; };
  for (const std::size_t size : sizes) bytes_ += rounded(size);
  if (bytes_ == 0) bytes_ = page;
  base_ = map_memory(bytes_, where);
  std::byte* at = base_;
  for (const std::size_t size : sizes) {
    at += rounded(size);
    pieces_.push_back(at - size);
  }
}

Lent::~Lent() {
  explain_taken_back(nullptr, 0);
  munmap(base_, bytes_);
}

void Lent::take_back() {
  mprotect(base_, bytes_, PROT_NONE);
  explain_taken_back(base_, bytes_);
}

}  // namespace mmverify::dock
