// mmverify-worker FD LIBRARY: calls a subject on the tool's behalf, in a process that may die of it.
#include <dlfcn.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "dock/codec_desk.hpp"
#include "dock/futex.hpp"
#include "dock/load_error.hpp"

// A sanitizer's own handlers would turn a crash into an exit.
extern "C" const char* __asan_default_options() {
  return "handle_segv=0:handle_sigbus=0:handle_abort=0:handle_sigfpe=0:handle_sigill=0:detect_leaks=0";
}

namespace {

using namespace mmverify::dock;

class Worker {
 public:
  Worker(std::byte* base, const Layout& layout, const mmverify_subject_t& subject)
      : desk_(base, layout, subject),
        codecs_(desk_),
        base_(base),
        layout_(layout),
        mailbox_(desk_.mailbox),
        subject_(subject) {}

  void serve() {
    for (std::uint64_t command = 0;; ++command) {
      while (mailbox_.turn.load(std::memory_order_acquire) != 1) futex_wait(mailbox_.turn, 0, 1000);
      run(command);
      // A copy that the subject forked comes back here, too.
      if (getpid() != self_) _exit(0);
      mailbox_.turn.store(0, std::memory_order_release);
      futex_wake(mailbox_.turn);
    }
  }

 private:
  void run(std::uint64_t command) {
    desk_.finish(Outcome::answered, 0, "");
    try {
      if (of_codec(mailbox_.call)) return codecs_.run();
      for (std::size_t slot = 0; in_slot(mailbox_.count, slot) != 0; ++slot) call_slot(slot);
      if (mailbox_.one_by_one != 0) return;
      const std::size_t batches = static_cast<std::size_t>((mailbox_.count + batch_size - 1) / batch_size);
      // The first command of a level is asked again in every way, all of it; the others, a batch in a way in
      // turn.
      for (std::size_t slot = 0; first_at_this_level() && slot < batches; ++slot) {
        for (const std::size_t size : {batch_size, std::size_t{7}, std::size_t{1}}) ask_again(slot, size);
        ask_from_threads(slot);
      }
      mark_level();
      constexpr std::size_t sizes[] = {batch_size, 7, batch_size - 1, 1};
      ask_again(command % batches, sizes[command / slots % 4]);
    } catch (const Stop&) {
    }
  }

  bool first_at_this_level() const {
    return (probed_[static_cast<std::size_t>(mailbox_.call)] >> (mailbox_.level % 32) & 1) == 0;
  }
  void mark_level() {
    probed_[static_cast<std::size_t>(mailbox_.call)] |= std::uint64_t{1} << (mailbox_.level % 32);
  }

  std::byte* input(std::size_t array, std::size_t slot, std::size_t count) const {
    return base_ + layout_.input_at(array, slot, count, input_size(mailbox_.call));
  }
  std::byte* answer(std::size_t slot, std::size_t count) const {
    return base_ + layout_.answer_at(slot, count, answer_size(mailbox_.call));
  }

  void call(const std::byte* first, const std::byte* second, std::byte* out, std::size_t count) const {
    const auto f = [](const std::byte* p) { return reinterpret_cast<const float*>(p); };
    const auto d = [](const std::byte* p) { return reinterpret_cast<const double*>(p); };
    const auto k = [](const std::byte* p) { return reinterpret_cast<const std::uint32_t*>(p); };
    auto* to = reinterpret_cast<std::uint32_t*>(out);
    switch (mailbox_.call) {
      case Call::index_f32:
        return subject_.index_f32(mailbox_.level, f(first), f(second), to, count);
      case Call::index_f64:
        return subject_.index_f64(mailbox_.level, d(first), d(second), to, count);
      case Call::corners:
        return subject_.corners(mailbox_.level, k(first), to, count);
      case Call::row_index_f32:
        return subject_.row_index_f32(mailbox_.level, f(first), f(second), to, count);
      case Call::row_corners:
        return subject_.row_corners(mailbox_.level, k(first), to, count);
      default:
        return;
    }
  }

  void guarded(const std::byte* first, const std::byte* second, std::byte* out, std::size_t count,
               std::uint64_t element) {
    desk_.guarded([&] { call(first, second, out, count); }, element);
  }

  void call_slot(std::size_t slot) {
    const std::size_t count = in_slot(mailbox_.count, slot), from = slot * batch_size;
    std::byte* out = answer(slot, count);
    std::memcpy(out - canary_size, untouched_.data(), canary_size);
    // Filling costs time; what the first command of a level covers is enough to see an output left alone.
    if (first_at_this_level()) std::memset(out, blank, count * answer_size(mailbox_.call));
    const std::size_t step = mailbox_.one_by_one != 0 ? 1 : count, in = input_size(mailbox_.call);
    for (std::size_t at = 0; at < count; at += step) {
      mailbox_.begun.store(from + at, std::memory_order_relaxed);
      guarded(input(0, slot, count) + at * in, input(1, slot, count) + at * in,
              out + at * answer_size(mailbox_.call), step, from + at);
    }
    if (std::memcmp(out - canary_size, untouched_.data(), canary_size) != 0) {
      desk_.stop(Outcome::wrote_before, from, "");
    }
  }

  /// Asks a batch again in pieces of another size, and so at other places and addresses.
  void ask_again(std::size_t slot, std::size_t size) {
    mailbox_.begun.store(slot * batch_size, std::memory_order_relaxed);
    const std::size_t count = in_slot(mailbox_.count, slot), in = input_size(mailbox_.call),
                      wide = answer_size(mailbox_.call);
    again_.assign(count * wide, std::byte{blank_again});
    for (std::size_t at = 0; at < count; at += size)
      guarded(input(0, slot, count) + at * in, input(1, slot, count) + at * in, again_.data() + at * wide,
              std::min(size, count - at), slot * batch_size + at);
    compare(slot, again_, size == batch_size ? "asked again" : "asked in batches of " + std::to_string(size));
  }

  void compare(std::size_t slot, const std::vector<std::byte>& again, const std::string& how) {
    const std::size_t count = in_slot(mailbox_.count, slot), wide = answer_size(mailbox_.call);
    const std::byte* before = answer(slot, count);
    if (std::memcmp(before, again.data(), count * wide) == 0) return;
    for (std::size_t t = 0; t < count; ++t) {
      if (std::memcmp(before + t * wide, again.data() + t * wide, wide) == 0) continue;
      const auto blank_element = again.begin() + static_cast<std::ptrdiff_t>(t * wide);
      if (std::all_of(blank_element, blank_element + static_cast<std::ptrdiff_t>(wide),
                      [](std::byte b) { return b == std::byte{blank_again}; })) {
        desk_.stop(Outcome::unwritten, slot * batch_size + t, "");
      }
      std::uint32_t first = 0, second = 0;
      std::memcpy(&first, before + t * wide, sizeof first);
      std::memcpy(&second, again.data() + t * wide, sizeof second);
      std::string text = how;
      text.append(": ")
          .append(std::to_string(first))
          .append(" before, ")
          .append(std::to_string(second))
          .append(" then");
      desk_.stop(Outcome::non_deterministic, slot * batch_size + t, text);
    }
  }

  /// Two threads ask the same batch at once, several times.
  void ask_from_threads(std::size_t slot) {
    if ((subject_.flags & MMVERIFY_SINGLE_THREADED) != 0) return;
    const std::size_t count = in_slot(mailbox_.count, slot), wide = answer_size(mailbox_.call);
    constexpr int rounds = 4;
    std::vector<std::byte> theirs[2];
    bool threw[2] = {false, false};
    const auto ask = [&](int thread) {
      theirs[thread].assign(rounds * count * wide, std::byte{blank_again});
      try {
        for (int round = 0; round < rounds; ++round)
          call(input(0, slot, count), input(1, slot, count),
               theirs[thread].data() + static_cast<std::size_t>(round) * count * wide, count);
      } catch (...) {
        threw[thread] = true;
      }
    };
    std::thread other([&] {
      desk_.leave_processor();
      ask(1);
    });
    ask(0);
    other.join();
    for (int thread = 0; thread < 2; ++thread) {
      if (threw[thread]) {
        desk_.stop(Outcome::threw, slot * batch_size, "when called from two threads at once");
      }
      for (int round = 0; round < rounds; ++round) {
        const auto from = theirs[thread].begin() +
                          static_cast<std::ptrdiff_t>(static_cast<std::size_t>(round) * count * wide);
        again_.assign(from, from + static_cast<std::ptrdiff_t>(count * wide));
        compare(slot, again_, "asked from two threads at once");
      }
    }
  }

  Desk desk_;
  CodecDesk codecs_;
  std::byte* base_;
  Layout layout_;
  Mailbox& mailbox_;
  const mmverify_subject_t& subject_;
  pid_t self_ = getpid();
  std::uint64_t probed_[calls] = {};
  std::vector<std::byte> again_;
  const std::vector<std::byte> untouched_ = std::vector<std::byte>(canary_size, std::byte{canary});
};

// For the handler, which can only reach what is static.
std::byte* mapped = nullptr;
const Layout* mapped_layout = nullptr;

/// Says where a wild access landed, then lets the crash happen.
void on_fault(int signal, siginfo_t* info, void*) {
  const auto* at = static_cast<const std::byte*>(info->si_addr);
  if (mapped != nullptr && at >= mapped && at < mapped + mapped_layout->total()) {
    const auto offset = static_cast<std::size_t>(at - mapped);
    const bool of_inputs = offset < mapped_layout->answer(0) - mapped_layout->page() ||
                           (offset >= mapped_layout->blob() && offset < mapped_layout->blob_answer());
    const char* what =
        of_inputs ? "it wrote to its input or read past its end" : "it touched memory outside its output";
    std::strcpy(reinterpret_cast<Mailbox*>(mapped)->message, what);
  }
  std::signal(signal, SIG_DFL);
  raise(signal);
}

void explain_faults(std::byte* base, const Layout& layout) {
  mapped = base;
  mapped_layout = &layout;
  // A stack of its own: the fault may be a stack that ran out.
  static std::byte stack[1 << 16];
  const stack_t own{.ss_sp = stack, .ss_flags = 0, .ss_size = sizeof stack};
  sigaltstack(&own, nullptr);
  struct sigaction action {};
  action.sa_sigaction = on_fault;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigaction(SIGSEGV, &action, nullptr);
  sigaction(SIGBUS, &action, nullptr);
}

/// Maps the shared memory with nothing between the slots, and inputs that cannot be written.
std::byte* map(int fd, const Layout& layout) {
  auto* base = static_cast<std::byte*>(
      mmap(nullptr, layout.total(), PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0));
  if (base == MAP_FAILED) return nullptr;
  const auto place = [&](std::size_t offset, std::size_t bytes, int protection) {
    return mmap(base + offset, bytes, protection, MAP_SHARED | MAP_FIXED, fd, static_cast<off_t>(offset)) !=
           MAP_FAILED;
  };
  bool done = place(0, layout.mailbox_bytes(), PROT_READ | PROT_WRITE);
  for (std::size_t slot = 0; slot < slots; ++slot) {
    for (const std::size_t array : {std::size_t{0}, std::size_t{1}})
      done = done && place(layout.input(array, slot), layout.input_bytes(), PROT_READ);
    done = done && place(layout.answer(slot), layout.answer_bytes(), PROT_READ | PROT_WRITE);
  }
  done = done && place(layout.blob(), layout.blob_bytes(), PROT_READ) &&
         place(layout.blob_answer(), layout.blob_answer_bytes(), PROT_READ | PROT_WRITE);
  return done ? base : nullptr;
}

/// The subject's description, entry points that its header did not have yet null.
mmverify_subject_t as_of_today(const mmverify_subject_t& theirs) {
  mmverify_subject_t ours{};
  // Whole pointers only: a size in the middle of one says nothing of it.
  const std::size_t size = std::min<std::size_t>(theirs.size, sizeof ours) / sizeof(void*) * sizeof(void*);
  std::memcpy(&ours, &theirs, size);
  return ours;
}

/// Bytes of the first version of mmverify_subject_t, which ended with row_corners.
constexpr std::size_t first_size = offsetof(mmverify_subject_t, tree_encode);

std::string cannot_load(Description& description, const char* library, mmverify_subject_t& subject) {
  void* handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) return load_error(library);
  using Get = const mmverify_subject_t* (*)();
  const auto get = reinterpret_cast<Get>(dlsym(handle, "mmverify_subject_v1"));
  if (get == nullptr) return "it does not export mmverify_subject_v1";
  const mmverify_subject_t* theirs = get();
  if (theirs == nullptr) return "mmverify_subject_v1 returned null";
  if (theirs->abi != MMVERIFY_SUBJECT_ABI)
    return "it was built for version " + std::to_string(theirs->abi) + " of the interface, this is version " +
           std::to_string(MMVERIFY_SUBJECT_ABI);
  if (theirs->size < first_size) return "its size field is smaller than mmverify_subject_t";
  subject = as_of_today(*theirs);
  if (subject.max_level > 16) return "its max_level is above 16";
  description.max_level = subject.max_level;
  description.flags = subject.flags;
  const auto& s = subject;
  const auto given = [](auto... entry) { return std::array<bool, calls>{entry != nullptr...}; };
  // In the order of Call.
  const auto has =
      given(s.index_f32, s.index_f64, s.corners, s.row_index_f32, s.row_corners, s.tree_encode, s.tree_decode,
            s.tree_lookup, s.tree_lookup_f32, s.micromap_pack, s.micromap_unpack, s.micromap_force2,
            s.micromap_widen, s.micromap_up, s.micromap_down, s.micromap_through, s.micromap_substitute,
            s.vq2_decode, s.vq2_region, s.vq2_encode, s.vq4_decode, s.vq4_region, s.vq4_encode, s.bake);
  description.has = 0;
  for (std::uint32_t c = 0; c < calls; ++c) description.has |= has[c] ? 1u << c : 0u;
  if (description.has == 0) return "all its entry points are null";
  std::snprintf(description.name, sizeof description.name, "%s", subject.name == nullptr ? "" : subject.name);
  return {};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("mmverify-worker is started by mmverify\n", stderr);
    return 2;
  }
  // Ctrl-C is the tool's business; a tool that dies takes its workers along; a crash leaves no core file.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGPIPE, SIG_DFL);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  // What a subject prints must not get into the results.
  dup2(STDERR_FILENO, STDOUT_FILENO);

  const Layout layout(static_cast<std::size_t>(sysconf(_SC_PAGESIZE)));
  std::byte* base = map(std::atoi(argv[1]), layout);
  if (base == nullptr) return 4;
  auto& mailbox = *reinterpret_cast<Mailbox*>(base);
  mmverify_subject_t subject{};
  const std::string why = cannot_load(mailbox.description, argv[2], subject);
  mailbox.outcome = why.empty() ? Outcome::ready : Outcome::cannot_load;
  std::snprintf(mailbox.message, sizeof mailbox.message, "%s", why.c_str());
  mailbox.turn.store(0, std::memory_order_release);
  futex_wake(mailbox.turn);
  if (!why.empty()) return 0;
  explain_faults(base, layout);
  Worker(base, layout, subject).serve();
}
