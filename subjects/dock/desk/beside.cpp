// Asks while another thread writes the bytes next to the output: a subject that reads them and writes them back
// loses what was written in between.
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <thread>

#include "subjects/dock/desk/desk.hpp"

namespace mmverify::dock {
namespace {

/// A call's window for such a loss is some nanoseconds wide: so many calls are made while the other thread
/// writes, within so much time.
constexpr unsigned calls_beside = 300;
constexpr std::chrono::microseconds longest_beside(2000), longest_start(1000);
/// Elements of a batch, an odd number, and the longest answer: short calls meet the other thread more often.
constexpr std::size_t elements_beside = 3;
constexpr std::size_t longest_answer_beside = 4096;
/// The questions of a kind that are asked so.
constexpr bool is_asked_beside(std::uint32_t before) { return before == 1 || before == 6; }

/// The thread that writes the byte before an output and the byte behind it.
class Writer {
 public:
  Writer(std::byte* before, std::byte* behind, const cpu_set_t& processors)
      : before_(reinterpret_cast<unsigned char&>(*before)),
        behind_(reinterpret_cast<unsigned char&>(*behind)),
        thread_([this, processors] {
          sched_setaffinity(0, sizeof processors, &processors);
          write();
        }) {}
  ~Writer() { end(); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  unsigned turns() const { return turns_.load(std::memory_order_relaxed); }
  /// Whether the byte before, or the one behind, got an older value back.
  bool lost_before() const { return lost_before_; }
  bool lost_behind() const { return lost_behind_; }
  void end() {
    done_ = true;
    if (thread_.joinable()) thread_.join();
  }

 private:
  void write() {
    // Long enough for the call's store to arrive, short enough that many calls meet a new value.
    constexpr int looks = 24;
    unsigned char value = 0;
    while (!done_) {
      ++value;
      before_.store(value, std::memory_order_relaxed);
      behind_.store(value, std::memory_order_relaxed);
      // This thread reads its own stores before they are in memory.
      std::atomic_thread_fence(std::memory_order_seq_cst);
      for (int look = 0; look < looks; ++look) {
        if (before_.load(std::memory_order_relaxed) != value) lost_before_ = true;
        if (behind_.load(std::memory_order_relaxed) != value) lost_behind_ = true;
      }
      turns_.fetch_add(1, std::memory_order_relaxed);
    }
  }

  std::atomic_ref<unsigned char> before_, behind_;
  std::atomic<bool> done_ = false, lost_before_ = false, lost_behind_ = false;
  std::atomic<unsigned> turns_ = 0;
  std::thread thread_;  // the last member: it uses the others
};

}  // namespace

void Desk::ask_beside_a_writer(const Arguments& question, const std::byte* right, std::size_t bytes,
                               std::uint64_t size, std::uint64_t element) {
  using Clock = std::chrono::steady_clock;
  cpu_set_t others = everywhere_;
  if (const int here = sched_getcpu(); here >= 0 && here < CPU_SETSIZE)
    CPU_CLR(static_cast<std::size_t>(here), &others);
  // The two threads would never meet on one processor.
  if (bytes == 0 || size == 0 || CPU_COUNT(&others) == 0) return;
  const std::size_t value = asked().signature.value_bytes;
  // No word of eight bytes or more begins or ends with the output.
  const std::size_t behind_line = value == 1 ? 1 + 2 * (mailbox_.asked_before % 4) : value;
  Fenced out(bytes, blank_again, behind_line);
  std::byte *const before = out.data() - 1, *const behind = out.data() + bytes;
  Arguments a = question;
  a.out = out.data();
  std::uint64_t again = size;
  bool lost_before = false, lost_behind = false;
  {
    Writer writer(before, behind, others);
    const auto start = Clock::now();
    while (writer.turns() == 0 && Clock::now() - start < longest_start) std::this_thread::yield();
    const auto end = Clock::now() + longest_beside;
    unsigned turns = writer.turns();
    for (unsigned met = 0; met < calls_beside && again == size && Clock::now() < end;) {
      again = guarded(a, element);
      const unsigned now = writer.turns();
      met += now != turns ? 1 : 0;
      turns = now;
      if (writer.lost_before() || writer.lost_behind()) break;
    }
    writer.end();
    lost_before = writer.lost_before();
    lost_behind = writer.lost_behind();
  }
  *before = *behind = std::byte{canary};
  constexpr char lost[] = "over what another thread wrote there meanwhile";
  if (lost_before) stop(Outcome::wrote_before, element, lost);
  if (lost_behind) stop(Outcome::wrote_behind, element, lost);
  check_fence(out, element);
  constexpr char how[] = "asked while another thread writes next to its output";
  if (again != size)
    stop(Outcome::non_deterministic, element,
         how + (": " + std::to_string(size)) + " returned, then " + std::to_string(again));
  compare(right, out.data(), bytes / asked().answer_bytes, element, how);
}

void Desk::ask_slot_beside_a_writer(std::size_t slot) {
  const std::size_t count = std::min(in_slot(mailbox_.count, slot), elements_beside),
                    wide = asked().answer_bytes;
  Arguments a = piece(slot, 0, count, nullptr);
  a.room = count * wide;
  ask_beside_a_writer(a, slot_answer(slot), count * wide, count * wide, slot * batch_size);
}

void Desk::ask_blob_beside_a_writer(const std::uint8_t* blob, std::uint64_t size) {
  if (!is_asked_beside(mailbox_.asked_before)) return;
  if (std::max<std::size_t>(again_.size(), mailbox_.blob_bytes) > longest_answer_beside) return;
  Arguments a = whole(nullptr, again_.size());
  a.blob = blob;
  ask_beside_a_writer(a, again_.data(), again_.size(), size, 0);
}

}  // namespace mmverify::dock
