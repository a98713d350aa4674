#include "subjects/dock/desk/gate.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cstring>
#include <new>

#include "subjects/dock/futex.hpp"

namespace mmverify::dock {
namespace {

// Static data, since a signal handler can reach nothing else.
std::atomic<std::uintptr_t> gate_begin = 0, gate_end = 0;
std::atomic<std::uint32_t> is_open = 1;
std::atomic<unsigned> arrived = 0, late = 0;
/// Faults after the opening that may have been on their way; a further one is a write.
constexpr unsigned most_late = 256;

}  // namespace

Gate::Gate(const std::vector<std::span<const std::byte>>& inputs, bool closed) {
  static const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const auto rounded = [](std::size_t bytes) { return (bytes + page - 1) / page * page; };
  for (const auto& input : inputs) bytes_ += rounded(input.size());
  if (bytes_ == 0) bytes_ = page;
  void* const got = mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (got == MAP_FAILED) throw std::bad_alloc();
  base_ = static_cast<std::byte*>(got);
  std::byte* at = base_;
  for (const auto& input : inputs) {
    at += rounded(input.size());
    if (!input.empty()) std::memcpy(at - input.size(), input.data(), input.size());
    copies_.push_back(at - input.size());
  }
  arrived = 0;
  late = 0;
  is_open = closed ? 0 : 1;
  gate_end = reinterpret_cast<std::uintptr_t>(base_) + bytes_;
  gate_begin = reinterpret_cast<std::uintptr_t>(base_);
  mprotect(base_, bytes_, closed ? PROT_NONE : PROT_READ);
}

Gate::~Gate() {
  gate_begin = gate_end = 0;
  munmap(base_, bytes_);
}

unsigned Gate::waiting() { return arrived; }

void Gate::open() {
  mprotect(base_, bytes_, PROT_READ);
  is_open = 1;
}

bool Gate::holds_up(const void* at) {
  const auto address = reinterpret_cast<std::uintptr_t>(at);
  if (address < gate_begin || address >= gate_end) return false;
  if (is_open != 0) return ++late < most_late;
  ++arrived;
  while (is_open == 0) futex_wait(is_open, 0, 1);
  return true;
}

}  // namespace mmverify::dock
