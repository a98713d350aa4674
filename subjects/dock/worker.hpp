// A worker process: it answers questions to a subject, or the tool finds out why not.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "subjects/dock/layout.hpp"
#include "subjects/dock/library_file.hpp"
#include "subjects/dock/watch.hpp"

namespace mmverify::dock {

/// A library that is no subject: a missing symbol, another interface, not loadable, or endless loading.
/// what() names the file.
struct CannotLoad : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A library that says that it cannot run here; what() is its reason.
struct NotHere : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The misbehaviour of a subject that did not answer.
struct Misbehaved {
  std::string what;            ///< "crashed (signal 11, Segmentation fault)", "hung: ...", ...
  std::uint64_t first, count;  ///< the elements of the command that it happened on
  bool hung = false;           ///< it used up its time
  bool alone = false;          ///< a crash, hang or exception on this element, when asked alone, too
};

struct Options {
  double timeout_seconds = 10;  ///< for one call of the subject
  /// Seconds for loading the library: at least one, to read a large file.
  double loading_seconds() const { return std::max(1.0, timeout_seconds); }
  /// Seconds for all calls of one command, which may be a million: a bound on a worker that forges their
  /// count.
  double command_seconds() const { return std::max(3600.0, 1000 * timeout_seconds); }
  /// Called several times a second during a wait for an answer; an exception ends the wait.
  void (*stop_if_asked)() = [] {};
  std::vector<std::string> environment = {};  ///< NAME=VALUE each, for the workers only
  std::string called = {};                    ///< the subject's name; empty for the library's path
  std::string fingerprint = {};               ///< the subject's; empty for that of the library's contents
  std::shared_ptr<const void> keeps = {};     ///< an object that must outlive the workers
};

/// A question about a map or a code.
struct Question {
  Call call;
  std::uint32_t level, format;
  std::span<const std::uint8_t> blob;  ///< the map or the code, up to blob_capacity
  std::size_t room;         ///< bytes of the answer; for an encoder, the most that it may write at first
  std::uint64_t count = 0;  ///< number of a lookup's elements in input(); up to batch_size
};

/// The reply to a question; `bytes` stay valid until the next one.
struct Reply {
  bool taken;  ///< false: the map has no code, or the code is no map's
  std::span<const std::uint8_t> bytes;
};

/// The numbers of questions on maps and codes, by call, level and format: the first of each kind are repeated
/// in every way, which takes a hundred times as long as the answer.
using QuestionCounts = std::map<std::tuple<Call, std::uint32_t, std::uint32_t>, std::uint32_t>;

/// Facts from earlier workers.
struct Before {
  QuestionCounts asked = {};          ///< questions to the workers that this one replaces
  bool loaded = false;                ///< another worker has loaded the library
  const LibraryFile* file = nullptr;  ///< the file at that time; null: not checked
};

/// A process with the library loaded. Not thread-safe.
class Worker {
 public:
  /// Starts the process. CannotLoad if the library is no subject, NotHere if it says that it cannot run here,
  /// NoResources if no process can be started.
  /// If the library was loaded before, a failure now is a SubjectBroken; NoResources if it cannot be opened
  /// or its file has changed.
  Worker(std::string library, const Options& options, Before before = {});
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  const Description& description() const { return description_; }
  const QuestionCounts& asked() const { return asked_; }

  /// The places of element t's input and answer in a command of `count`. Domain: t < count <= capacity.
  std::byte* input(Call call, std::size_t array, std::uint64_t count, std::uint64_t t) const;
  const std::byte* answer(Call call, std::uint64_t count, std::uint64_t t) const;

  /// Runs the command on the inputs in place. Throws Misbehaved, or whatever Options::stop_if_asked throws;
  /// the worker is useless after that.
  /// Faults in the worker's own questions about other levels are ignored here: the commands of those levels
  /// find them.
  void ask(Call call, std::uint32_t level, std::uint64_t count, std::uint32_t format = 0);

  /// Asks about a map or a code. The elements in an exception are a lookup's.
  Reply ask(const Question& question);

 private:
  /// Starts a process and waits until it has loaded the library. Throws as the constructor.
  void start();
  void start_process();
  /// Waits for loading to end, and copies the description of the library.
  void wait_until_loaded();
  /// Ends the process and whatever it started.
  void stop();
  /// Whether the process has ended. It is not reaped, so that no other process gets its number. Throws
  /// NoResources if it was killed from outside.
  bool ended();
  /// The elements of the call of the subject that `element` belongs to, as first and count.
  std::pair<std::uint64_t, std::uint64_t> called_with(std::uint64_t element, std::uint64_t count) const;
  /// Moves the process to this thread's processor: only one of the two works at a time, the numbers are in
  /// that processor's cache, and no idle processor has to be woken. It waits for the first command, so that
  /// threads that a subject starts by itself may go anywhere.
  void bring_here();
  /// Hands the turn over and waits for it to come back with a report. False if the process ended, hung,
  /// exceeded a bound, or reports something impossible. Throws NoResources if the machine is to blame.
  bool exchange();
  /// Waits for the turn. False if the process ended, exceeded a bound, or took longer than `seconds`: for a
  /// call, or for loading, counted from the first touch of the library.
  bool wait_for_turn(double seconds, bool loading);
  /// Copies the report at once: the subject may change it while it is read.
  void take_report();
  /// Whether the worker can have made this report on the command: its outcome, its sizes. The element may
  /// belong to an earlier question or a longer batch; then the element at fault is unknown.
  bool report_is_possible() const;
  /// The number of elements before the batch in work.
  std::uint64_t begun() const;
  /// Passes on the worker's output; false if a bound is exceeded.
  bool within_bounds();
  /// The reason that wait_for_turn() found: a bound, "hung: ...", or end_of_process().
  std::string why_no_answer();
  /// The end of the process in words: "crashed (signal ...)" or "called exit(...)".
  std::string end_of_process();
  /// The misbehaviour that the outcome stands for; empty if the subject answered.
  std::string misdeed() const;
  /// Repeats the command in a new process that asks about no other level, after a crash on another level.
  void ask_of_this_level_alone(Call call, std::uint32_t level, std::uint64_t count, std::uint32_t format);
  /// Copies of elements [first, first + count) of the inputs of a command of `all`, array after array.
  std::vector<std::vector<std::byte>> inputs(Call call, std::uint64_t all, std::uint64_t first,
                                             std::uint64_t count) const;
  /// Writes the inputs of a command.
  void put(Call call, const std::vector<std::vector<std::byte>>& inputs);
  /// Asks element by element in a new process, to name the one at fault.
  void pin_down(Call call, std::uint32_t level, std::uint32_t format, std::uint64_t count, Misbehaved& found);

  std::string library_;
  Options options_;
  std::vector<std::string> environment_;  ///< the process's environment
  Layout layout_;
  int fd_ = -1, pid_ = -1, status_ = 0;
  int processor_ = -1;  ///< processor that bring_here() last chose
  bool hung_ = false;
  Bounds bounds_ = bounds();
  std::unique_ptr<Printed> printed_;
  std::string over_;  ///< the bound that it exceeded
  Description description_{};
  Report report_{};
  std::string message_;  ///< the report's message, cleaned
  /// The command under way, as sent: the subject may have changed the mailbox since.
  struct Sent {
    Call call{};
    std::uint64_t count = 0, room = 0;
  } sent_;
  std::uint64_t questions_ = 0;
  QuestionCounts asked_;
  bool loaded_before_;
  const LibraryFile* file_;
  std::array<bool, calls> this_level_alone_{};  ///< by call: a question about another level crashed
  std::byte* base_ = nullptr;
  Mailbox* mailbox_ = nullptr;
};

/// Idle workers, at most one for each thread. A thread gets its own worker back: whatever a subject keeps of
/// the last question then affects the next one of the same thread, however threads are scheduled.
class Pool {
 public:
  Pool(std::string library, const Options& options)
      : library_(std::move(library)), options_(options), file_(library_) {}

  std::unique_ptr<Worker> take();
  /// A new worker.
  std::unique_ptr<Worker> fresh();
  /// The library's file as it was before the first process.
  const LibraryFile& file() const { return file_; }
  void give_back(std::unique_ptr<Worker> worker);
  /// Ends a worker that did not answer. The counts of its questions go to later workers, so that a subject
  /// that crashes on a hundred cases does not get the first questions in every way a hundred times.
  void replace(std::unique_ptr<Worker> worker);
  const std::string& library() const { return library_; }

 private:
  std::string library_;
  Options options_;
  LibraryFile file_;
  std::atomic<bool> loaded_ = false;  ///< some worker has loaded the library
  std::mutex lock_;
  /// An idle worker, and the thread that gave it back.
  struct Idle {
    std::unique_ptr<Worker> worker;
    std::thread::id by;
  };
  std::vector<Idle> idle_;
  QuestionCounts asked_;  ///< by replaced workers: the most of each kind
};

}  // namespace mmverify::dock
