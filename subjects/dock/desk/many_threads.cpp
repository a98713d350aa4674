// Asks from many threads at once, each of which has never called before. They wait inside the subject for each
// other: a third buffer, or a table for each thread that ever came, is needed by then.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <span>
#include <string>
#include <system_error>
#include <thread>

#include "subjects/dock/desk/gate.hpp"
#include "subjects/dock/desk/provocations.hpp"

namespace mmverify::dock {
namespace {

constexpr unsigned many = 20;
const std::string from_many = "asked from " + std::to_string(many) + " threads at once";
/// Elements of a batch, and the largest map or code, that each asks.
constexpr std::size_t elements_of_each = 64, most_bytes_of_each = 1u << 14;
/// A subject with a lock lets one thread in: the others never reach its inputs. So the wait ends when no
/// further one has come for so long.
constexpr std::chrono::milliseconds none_comes(10);
/// The questions of a kind that are asked so.
constexpr bool is_asked_from_many(std::uint32_t before) { return before == 0 || before == 5; }

/// The number of threads to ask from: fewer where the subject has a team of threads for each caller, as the
/// process may have 512 in all.
unsigned number_of_callers() {
  constexpr std::size_t most_in_all = 256, fewest = 3;
  std::error_code error;
  const std::filesystem::directory_iterator tasks("/proc/self/task", error);
  const auto now = static_cast<std::size_t>(error ? 1 : std::distance(begin(tasks), end(tasks)));
  return static_cast<unsigned>(std::clamp<std::size_t>(most_in_all / now, fewest, many));
}

/// Opens the gate when all that will come have come.
void open_when_all_wait(Gate& gate, const std::atomic<unsigned>& done, unsigned threads) {
  using Clock = std::chrono::steady_clock;
  auto since = Clock::now();
  for (unsigned seen = 0; Clock::now() - since < none_comes;) {
    const unsigned now = Gate::waiting() + done;
    if (now >= threads) break;
    if (now != seen) since = Clock::now();
    seen = now;
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
  gate.open();
}

void ask_from_many(const Caller& caller, const Question& question) {
  if (caller.is_single_threaded()) return;
  const Signature& signature = caller.entry().signature;
  Arguments a = question.arguments;
  std::vector<std::span<const std::byte>> inputs;
  for (std::size_t array = 0; array < signature.arrays; ++array)
    inputs.emplace_back(a.arrays[array], a.count * signature.number_bytes);
  inputs.emplace_back(reinterpret_cast<const std::byte*>(a.blob), a.blob_bytes);
  // The kernel fails for a closed gate's memory: a device's driver, or a pipe, may hand it over.
  const bool reads_it_itself =
      (caller.subject().flags & MMVERIFY_LARGE_BATCHES) == 0 && std::getenv("MMVERIFY_UNCONFINED") == nullptr;
  Gate gate(inputs, reads_it_itself);
  for (std::size_t array = 0; array < signature.arrays; ++array) a.arrays[array] = gate.copy(array);
  a.blob = reinterpret_cast<const std::uint8_t*>(gate.copy(signature.arrays));
  std::vector<Answers> answers(number_of_callers());
  for (Answers& mine : answers) mine.rooms.emplace_back(question.bytes, blank_again);
  std::atomic<unsigned> done = 0;
  std::vector<std::thread> threads;
  std::optional<std::system_error> failed;
  for (Answers& mine : answers) try {
      threads.emplace_back([&] {
        sched_setaffinity(0, sizeof caller.processors(), &caller.processors());
        Arguments own = a;
        own.out = mine.rooms[0].data();
        mine.sizes.reserve(1);
        if (caller.call_in_thread(own, mine)) mine.left.signals = caller.signals_changed();
        ++done;
      });
    } catch (const std::system_error& e) {
      failed = e;
      break;
    }
  open_when_all_wait(gate, done, static_cast<unsigned>(threads.size()));
  for (std::thread& one : threads) one.join();
  if (failed) throw std::system_error(*failed);
  for (const Answers& mine : answers) {
    if (mine.threw) caller.stop(Outcome::threw, question.element, "when called from many threads at once");
    caller.check_left(mine.left, question.element, "in a thread");
    caller.check_fence(mine.rooms[0], question.element);
    caller.compare(question, mine.sizes[0], mine.in_round(0), from_many);
  }
}

}  // namespace

void from_many_threads(const Batch& batch) {
  ask_from_many(batch.caller, batch.question(std::min(batch.count(), elements_of_each)));
}

void from_many_threads(const Blob& blob) {
  if (!is_asked_from_many(blob.before())) return;
  if (std::max<std::uint64_t>(blob.answer.size(), blob.blob_bytes()) > most_bytes_of_each) return;
  ask_from_many(blob.caller, blob.question());
}

}  // namespace mmverify::dock
