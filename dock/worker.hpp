// A worker process and what it is asked: a subject's answers, or why there are none.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
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

#include "dock/layout.hpp"
#include "dock/library_file.hpp"
#include "dock/watch.hpp"

namespace mmverify::dock {

/// A library that is no subject: missing symbol, another interface, not loadable, no end of loading.  what() names the
/// file.
struct CannotLoad : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A library that says that it cannot run here; what() is its reason.
struct NotHere : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a subject did instead of answering.
struct Misbehaved {
  std::string what;            ///< "crashed (signal 11, Segmentation fault)", "hung: ...", ...
  std::uint64_t first, count;  ///< the elements of the command during which it did
  bool hung = false;           ///< it took all the time that it may
  bool alone = false;  ///< a crash, a hang or an exception on this one element, asked by itself as well
};

struct Options {
  double timeout_seconds = 10;  ///< for one call of the subject
  /// For loading it: a second at least, in which a large library is read.
  double loading_seconds() const { return std::max(1.0, timeout_seconds); }
  /// For all calls of one command, of which there may be a million: a bound for a worker that forges their count.
  double command_seconds() const { return std::max(3600.0, 1000 * timeout_seconds); }
  /// Called while an answer is waited for, several times a second; what it throws ends the wait.
  void (*stop_if_asked)() = [] {};
  std::vector<std::string> environment = {};  ///< NAME=VALUE each, for the workers alone
  std::string called = {};                    ///< the subject's name; empty: the library's path
  std::string fingerprint = {};               ///< what it is known by; empty: by the library's contents
  std::shared_ptr<const void> keeps = {};     ///< what has to outlive the workers
};

/// What is asked about a map or a code.
struct Question {
  Call call;
  std::uint32_t level, format;
  std::span<const std::uint8_t> blob;  ///< the map or the code, up to blob_capacity
  std::size_t room;         ///< bytes of the answer; of an encoder's, as many as it may write at first
  std::uint64_t count = 0;  ///< of a lookup's elements, which lie in input(); up to batch_size
};

/// `bytes` stay where they are until the next question.
struct Reply {
  bool taken;  ///< false: there is no code of this map, or the code is no map's
  std::span<const std::uint8_t> bytes;
};

/// How many questions on maps and codes were asked, by call, level and format: the first of each kind are asked in every
/// way, which takes a hundred times as long as the answer.
using QuestionCounts = std::map<std::tuple<Call, std::uint32_t, std::uint32_t>, std::uint32_t>;

/// Knowledge from earlier workers.
struct Before {
  QuestionCounts asked = {};          ///< what those were asked whose place this one takes
  bool loaded = false;                ///< another one has loaded the library
  const LibraryFile* file = nullptr;  ///< as it was then; null: nobody looks
};

/// One process with the library loaded. Not for two threads at once.
class Worker {
 public:
  /// Starts it; CannotLoad where the library is no subject, NotHere where it says so, NoResources where no process can
  /// be had.
  /// Of a library that was loaded before, what comes in the way now is a SubjectBroken; NoResources where it cannot be
  /// opened or where its file is another by now.
  Worker(std::string library, const Options& options, Before before = {});
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  const Description& description() const { return description_; }
  const QuestionCounts& asked() const { return asked_; }

  /// Where element t of a command of `count` goes, and where its answer comes.  Domain: t < count <=
  /// capacity.
  std::byte* input(Call call, std::size_t array, std::uint64_t count, std::uint64_t t) const;
  const std::byte* answer(Call call, std::uint64_t count, std::uint64_t t) const;

  /// Runs the command on the inputs in place.  Throws Misbehaved, or what Options::stop_if_asked throws; the
  /// worker is of no use after that.
  /// What the worker itself asks about other levels ends no command: the command of that level finds it.
  void ask(Call call, std::uint32_t level, std::uint64_t count, std::uint32_t format = 0);

  /// The same for a map or a code.  The elements of what is thrown are a lookup's.
  Reply ask(const Question& question);

 private:
  /// Starts a process and waits until it has loaded the library.  Throws as the constructor does.
  void start();
  void start_process();
  /// Waits, and takes over what it says of the library.
  void wait_until_loaded();
  /// Ends the process, and whatever it started.
  void stop();
  /// Whether the process has ended; it stays to be reaped, so that nothing else gets its number.  Throws NoResources
  /// where it was ended from outside.
  bool ended();
  /// The elements of a command that one call of the subject is about: those around `element`.
  std::pair<std::uint64_t, std::uint64_t> called_with(std::uint64_t element, std::uint64_t count) const;
  /// Brings the process to the processor that this thread runs on: only one of the two has work at a time,
  /// the numbers are in that processor's cache, and nobody has to be woken on an idle one.  Not before its
  /// first command, so that threads which a subject starts for itself go where they like.
  void bring_here();
  /// Hands the turn over and waits for it to come back, with a report.  False where the process ended, hung, went over
  /// a bound, or where what it reports cannot be.  Throws NoResources where the machine is to blame.
  bool exchange();
  /// Waits for the turn.  False where the process ended, went over a bound, or took longer than `seconds`: for a call,
  /// or for loading, which counts from the moment when the library is touched.
  bool wait_for_turn(double seconds, bool loading);
  /// Takes the report over, in one go: what runs in the worker may change it while it is read.
  void take_report();
  /// Whether the report is one that the worker can make of the command: outcome, sizes.  Its element may be one of an
  /// earlier question's, or of a longer batch; then nobody knows which of this command's it is.
  bool report_is_possible() const;
  /// Elements before the batch that it works on.
  std::uint64_t begun() const;
  /// Passes on what it printed; false where it went over a bound.
  bool within_bounds();
  /// What wait_for_turn() found: a bound, "hung: ...", or end_of_process().
  std::string why_no_answer();
  /// "crashed (signal ...)" or "called exit(...)" of the ended process.
  std::string end_of_process();
  /// What the subject did, by the outcome; empty where it answered.
  std::string misdeed() const;
  /// Of a new process, after a crash on another level.
  void ask_of_this_level_alone(Call call, std::uint32_t level, std::uint64_t count, std::uint32_t format);
  /// Elements [first, first + count) of the inputs of a command of `all`, array after array.
  std::vector<std::vector<std::byte>> inputs(Call call, std::uint64_t all, std::uint64_t first,
                                             std::uint64_t count) const;
  /// As the inputs of a command.
  void put(Call call, const std::vector<std::vector<std::byte>>& inputs);
  /// Asks element by element in a new process, to name the one.
  void pin_down(Call call, std::uint32_t level, std::uint32_t format, std::uint64_t count, Misbehaved& found);

  std::string library_;
  Options options_;
  std::vector<std::string> environment_;  ///< of the process
  Layout layout_;
  int fd_ = -1, pid_ = -1, status_ = 0;
  int processor_ = -1;  ///< where bring_here() last brought it
  bool hung_ = false;
  Bounds bounds_ = bounds();
  std::unique_ptr<Printed> printed_;
  std::string over_;  ///< which bound it went over
  Description description_{};
  Report report_{};
  std::string message_;  ///< the report's, clean
  /// The command under way, as it was sent: what stands in the mailbox may be another one by now.
  struct Sent {
    Call call{};
    std::uint64_t count = 0, room = 0;
  } sent_;
  std::uint64_t questions_ = 0;
  QuestionCounts asked_;
  bool loaded_before_;
  const LibraryFile* file_;
  std::array<bool, calls> this_level_alone_{};  ///< by call: it has crashed on another level
  std::byte* base_ = nullptr;
  Mailbox* mailbox_ = nullptr;
};

/// Workers that wait for use, one a thread at most.  A thread gets the one again that it gave back: what a subject has in
/// mind of a thread's last question then shows in its next one, however threads meet.
class Pool {
 public:
  Pool(std::string library, const Options& options)
      : library_(std::move(library)), options_(options), file_(library_) {}

  std::unique_ptr<Worker> take();
  /// A process that was asked nothing yet.
  std::unique_ptr<Worker> fresh();
  /// The library's file, as it was before the first process.
  const LibraryFile& file() const { return file_; }
  void give_back(std::unique_ptr<Worker> worker);
  /// Ends one that did not answer.  A subject that crashes on a hundred cases is not asked the first ones of a worker in
  /// every way a hundred times.
  void replace(std::unique_ptr<Worker> worker);
  const std::string& library() const { return library_; }

 private:
  std::string library_;
  Options options_;
  LibraryFile file_;
  std::atomic<bool> loaded_ = false;  ///< by some worker
  std::mutex lock_;
  /// Who gave it back.
  struct Idle {
    std::unique_ptr<Worker> worker;
    std::thread::id by;
  };
  std::vector<Idle> idle_;
  QuestionCounts asked_;  ///< of those that were replaced, the most of each kind
};

}  // namespace mmverify::dock
