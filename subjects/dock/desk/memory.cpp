#include "subjects/dock/desk/memory.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <string>

#include "subjects/dock/desk/gate.hpp"

namespace mmverify::dock {
namespace {

// Static data, since the signal handler can reach nothing else.
std::byte* mapped = nullptr;
const Layout* mapped_layout = nullptr;
const std::byte* taken_back = nullptr;
std::size_t taken_back_bytes = 0;

/// Writes into the mailbox where a wild access landed, then lets the process crash.
void on_fault(int signal, siginfo_t* info, void*) {
  const int error = errno;
  if (Gate::holds_up(info->si_addr)) {
    errno = error;
    return;
  }
  const auto* at = static_cast<const std::byte*>(info->si_addr);
  if (mapped != nullptr && at >= mapped && at < mapped + mapped_layout->total()) {
    const auto offset = static_cast<std::size_t>(at - mapped);
    const bool of_inputs = offset < mapped_layout->answer(0) - mapped_layout->page() ||
                           (offset >= mapped_layout->blob() && offset < mapped_layout->blob_answer());
    const char* what =
        of_inputs ? "it wrote to its input or read past its end" : "it touched memory outside its output";
    std::strcpy(reinterpret_cast<Mailbox*>(mapped)->report.message, what);
  }
  if (mapped != nullptr && taken_back != nullptr && at >= taken_back && at < taken_back + taken_back_bytes)
    std::strcpy(reinterpret_cast<Mailbox*>(mapped)->report.message,
                "it touched the memory of an earlier call, which its caller has taken back");
  std::signal(signal, SIG_DFL);
  raise(signal);
}

}  // namespace

void explain_faults(std::byte* base, const Layout& layout) {
  mapped = base;
  mapped_layout = &layout;
  // The handler has a stack of its own: the fault may be a stack overflow.
  static std::byte stack[1 << 16];
  const stack_t own{.ss_sp = stack, .ss_flags = 0, .ss_size = sizeof stack};
  sigaltstack(&own, nullptr);
  struct sigaction action {};
  action.sa_sigaction = on_fault;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigaction(SIGSEGV, &action, nullptr);
  sigaction(SIGBUS, &action, nullptr);
}

void explain_taken_back(const std::byte* base, std::size_t bytes) {
  taken_back = base;
  taken_back_bytes = bytes;
}

std::byte* map(int fd, const Layout& layout) {
  auto* base = static_cast<std::byte*>(
      mmap(nullptr, layout.total(), PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0));
  if (base == MAP_FAILED) return nullptr;
  // Memory that only the tool writes is mapped from a read-only descriptor, so that mprotect() cannot make it
  // writable.
  const int read_only = open(("/proc/self/fd/" + std::to_string(fd)).c_str(), O_RDONLY | O_CLOEXEC);
  const auto place = [&](std::size_t offset, std::size_t bytes, int protection) {
    const int from = protection == PROT_READ && read_only >= 0 ? read_only : fd;
    return mmap(base + offset, bytes, protection, MAP_SHARED | MAP_FIXED, from, static_cast<off_t>(offset)) !=
           MAP_FAILED;
  };
  bool done = place(0, layout.mailbox_bytes(), PROT_READ | PROT_WRITE);
  for (std::size_t slot = 0; slot < slots; ++slot) {
    for (std::size_t array = 0; array < most_arrays; ++array)
      done = done && place(layout.input(array, slot), layout.input_bytes(), PROT_READ);
    done = done && place(layout.answer(slot), layout.answer_bytes(), PROT_READ | PROT_WRITE);
  }
  done = done && place(layout.blob(), layout.blob_bytes(), PROT_READ) &&
         place(layout.blob_answer(), layout.blob_answer_bytes(), PROT_READ | PROT_WRITE);
  if (read_only >= 0) close(read_only);
  close(fd);
  return done ? base : nullptr;
}

}  // namespace mmverify::dock
