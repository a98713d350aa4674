// Asks while another thread writes the bytes next to the output: a subject that reads them and writes them back
// loses what was written in between.
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "subjects/dock/desk/provocations.hpp"

namespace mmverify::dock {
namespace {

/// A call's window for such a loss is some nanoseconds wide: so many calls are made while the other thread
/// writes, within so much time.  On a busy machine the two threads seldom run at once: fewer calls, and more time, are
/// enough there.
constexpr unsigned calls_beside = 300, least_calls_beside = 50;
constexpr std::chrono::microseconds longest_beside(2000), longest_if_busy(40'000), longest_start(1000);
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

void ask_beside(const Caller& caller, const Question& question) {
  using Clock = std::chrono::steady_clock;
  cpu_set_t others = caller.processors();
  if (const int here = sched_getcpu(); here >= 0 && here < CPU_SETSIZE)
    CPU_CLR(static_cast<std::size_t>(here), &others);
  // The two threads would never meet on one processor.
  if (question.bytes == 0 || question.size == 0 || CPU_COUNT(&others) == 0) return;
  const std::size_t value = caller.entry().signature.value_bytes;
  // No word of eight bytes or more begins or ends with the output.
  Fenced out(question.bytes, blank_again, value == 1 ? 1 + 2 * (caller.mailbox().asked_before % 4) : value);
  std::byte *const before = out.data() - 1, *const behind = out.data() + question.bytes;
  Arguments a = question.arguments;
  a.out = out.data();
  std::uint64_t again = question.size;
  bool lost_before = false, lost_behind = false;
  {
    Writer writer(before, behind, others);
    const auto start = Clock::now();
    while (writer.turns() == 0 && Clock::now() - start < longest_start) std::this_thread::yield();
    const auto begin = Clock::now();
    const auto has_time = [begin](unsigned met) {
      return Clock::now() - begin < (met < least_calls_beside ? longest_if_busy : longest_beside);
    };
    unsigned turns = writer.turns();
    for (unsigned met = 0; met < calls_beside && again == question.size && has_time(met);) {
      again = caller.guarded(a, question.element);
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
  if (lost_before) caller.stop(Outcome::wrote_before, question.element, lost);
  if (lost_behind) caller.stop(Outcome::wrote_behind, question.element, lost);
  caller.check_fence(out, question.element);
  caller.compare(question, again, out.data(), "asked while another thread writes next to its output");
}

}  // namespace

void beside_a_writer(const Batch& batch) {
  ask_beside(batch.caller, batch.question(std::min(batch.count(), elements_beside)));
}

void beside_a_writer(const Blob& blob) {
  if (!is_asked_beside(blob.before())) return;
  if (std::max<std::uint64_t>(blob.answer.size(), blob.blob_bytes()) > longest_answer_beside) return;
  ask_beside(blob.caller, blob.question());
}

}  // namespace mmverify::dock
