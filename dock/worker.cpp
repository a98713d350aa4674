#include "dock/worker.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "dock/broken.hpp"
#include "dock/futex.hpp"
#include "dock/sanitizer.hpp"

namespace mmverify::dock {
namespace {

/// The program that workers run: MMVERIFY_WORKER, or beside this program, or where it is installed.
std::string worker_program() {
  if (const char* named = std::getenv("MMVERIFY_WORKER")) return named;
  std::error_code error;
  const auto here = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const auto& place : {here / "mmverify-worker", here / "../libexec/mmverify/mmverify-worker"})
    if (std::filesystem::exists(place, error)) return place.string();
  throw std::runtime_error(
      fmt::format("mmverify-worker is not beside {}; set MMVERIFY_WORKER to its path", here.string()));
}

[[noreturn]] void fail(const char* what) {
  throw NoResources(fmt::format("{}: {}", what, std::strerror(errno)));
}

/// In so many questions that come fast, its bounds are looked at once: a wait looks by itself.
constexpr std::uint64_t unwatched = 256;

/// How often a wait looks whether the process still lives.
constexpr long slice_milliseconds = 20;

/// Values of processor_ that are no processor.
constexpr int anywhere = -1, not_asked = -2;

}  // namespace

Worker::Worker(std::string library, const Options& options, QuestionCounts asked)
    : library_(std::move(library)),
      options_(options),
      environment_(worker_environment(library_)),
      layout_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))),
      asked_(std::move(asked)) {
  environment_.insert(environment_.end(), options_.environment.begin(), options_.environment.end());
  start();
}

Worker::~Worker() { stop(); }

void Worker::start() {
  fd_ = memfd_create("mmverify-subject", 0);
  if (fd_ < 0 || ftruncate(fd_, static_cast<off_t>(layout_.total())) != 0)
    fail("cannot get memory for a worker");
  base_ = static_cast<std::byte*>(mmap(nullptr, layout_.total(), PROT_READ | PROT_WRITE, MAP_SHARED, fd_, 0));
  if (base_ == MAP_FAILED) fail("cannot map a worker's memory");
  mailbox_ = reinterpret_cast<Mailbox*>(base_);
  mailbox_->turn.store(1);
  mailbox_->outcome = Outcome::cannot_load;  // until the worker says otherwise

  const std::string program = worker_program(), fd = fmt::format("{}", fd_);
  std::string name = "mmverify-worker", fd_text = fd, library = std::filesystem::absolute(library_).string();
  char* argv[] = {name.data(), fd_text.data(), library.data(), nullptr};
  printed_ = std::make_unique<Printed>();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, printed_->write_end(), STDERR_FILENO);
  // A group of its own: what a subject forks ends with it, and Ctrl-C stays this process's business.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  std::vector<char*> environment;
  for (std::string& setting : environment_) environment.push_back(setting.data());
  environment.push_back(nullptr);
  const int error = posix_spawn(&pid_, program.c_str(), &actions, &attributes, argv, environment.data());
  posix_spawn_file_actions_destroy(&actions);
  printed_->close_write_end();
  posix_spawnattr_destroy(&attributes);
  if (error != 0) {
    pid_ = -1;
    errno = error;
    fail("cannot start mmverify-worker");
  }
  hung_ = false;
  over_.clear();
  processor_ = not_asked;
  group_ = pid_;
  while (mailbox_->turn.load(std::memory_order_acquire) == 1) {
    futex_wait(mailbox_->turn, 1, slice_milliseconds);
    options_.stop_if_asked();
    if (!within_bounds()) throw CannotLoad(fmt::format("{}: {} while it was loaded", library_, over_));
    if (mailbox_->turn.load(std::memory_order_acquire) == 1 && waitpid(pid_, &status_, WNOHANG) == pid_) {
      pid_ = -1;
      throw CannotLoad(fmt::format("{}: {} while it was loaded", library_, end_of_process()));
    }
  }
  if (mailbox_->outcome == Outcome::not_here) throw NotHere(mailbox_->message);
  if (mailbox_->outcome == Outcome::cannot_load)
    throw CannotLoad(fmt::format("{}: {}", library_, mailbox_->message));
}

void Worker::stop() {
  if (group_ > 0) kill(-group_, SIGKILL);
  if (pid_ > 0) waitpid(pid_, &status_, 0);
  pid_ = group_ = -1;
  printed_.reset();
  if (base_ != nullptr && base_ != MAP_FAILED) munmap(base_, layout_.total());
  base_ = nullptr;
  if (fd_ >= 0) close(fd_);
  fd_ = -1;
}

void Worker::bring_here() {
  if (processor_ == not_asked) {
    processor_ = anywhere;
    return;
  }
  const int here = sched_getcpu();
  if (here == processor_ || here < 0 || here >= CPU_SETSIZE) return;
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(static_cast<std::size_t>(here), &only);
  // Where it may not, it runs as well elsewhere.
  if (sched_setaffinity(pid_, sizeof only, &only) == 0) processor_ = here;
}

bool Worker::within_bounds() {
  if (!printed_->pass_on())
    over_ = fmt::format("printed more than {} KiB", Printed::most >> 10);
  else
    over_ = over(bounds_, pid_);
  return over_.empty();
}

bool Worker::exchange() {
  using Clock = std::chrono::steady_clock;
  bring_here();
  mailbox_->begun.store(0);
  mailbox_->turn.store(1, std::memory_order_release);
  futex_wake(mailbox_->turn);
  std::uint64_t calls = mailbox_->calls.load(std::memory_order_relaxed);
  auto since = Clock::now();
  while (mailbox_->turn.load(std::memory_order_acquire) == 1) {
    futex_wait(mailbox_->turn, 1, slice_milliseconds);
    if (mailbox_->turn.load(std::memory_order_acquire) != 1) break;
    options_.stop_if_asked();
    if (waitpid(pid_, &status_, WNOHANG) == pid_) {
      pid_ = -1;
      return false;
    }
    if (!within_bounds()) return false;
    if (const std::uint64_t now = mailbox_->calls.load(std::memory_order_relaxed); now != calls) {
      calls = now;
      since = Clock::now();
    } else if (std::chrono::duration<double>(Clock::now() - since).count() > options_.timeout_seconds) {
      hung_ = true;
      return false;
    }
  }
  return ++questions_ % unwatched != 0 || within_bounds();
}

std::string Worker::end_of_process() {
  printed_->pass_on();
  if (WIFSIGNALED(status_)) {
    const int signal = WTERMSIG(status_);
    std::string why = mailbox_->message;
    if (const std::string& report = printed_->report(); !report.empty()) why = report;
    return fmt::format("crashed (signal {}, {}){}", signal, strsignal(signal), why.empty() ? "" : ": " + why);
  }
  return fmt::format("called exit({})", WEXITSTATUS(status_));
}

std::string Worker::why_no_answer() {
  if (!over_.empty()) return over_;
  return hung_ ? fmt::format("hung: no answer within {} s", options_.timeout_seconds) : end_of_process();
}

std::vector<std::vector<std::byte>> Worker::inputs(Call call, std::uint64_t all, std::uint64_t first,
                                                   std::uint64_t count) const {
  const Signature signature = entry_point(call).signature;
  std::vector<std::vector<std::byte>> each(signature.arrays);
  for (std::size_t array = 0; array < signature.arrays; ++array)
    for (std::uint64_t t = first; t < first + count; ++t) {
      const std::byte* from = input(call, array, all, t);
      each[array].insert(each[array].end(), from, from + signature.number_bytes);
    }
  return each;
}

void Worker::put(Call call, const std::vector<std::vector<std::byte>>& inputs) {
  const std::size_t size = entry_point(call).signature.number_bytes;
  for (std::size_t array = 0; array < inputs.size(); ++array) {
    const std::uint64_t count = inputs[array].size() / size;
    for (std::uint64_t t = 0; t < count; t += batch_size)
      std::memcpy(input(call, array, count, t), inputs[array].data() + t * size,
                  std::min<std::uint64_t>(batch_size, count - t) * size);
  }
}

void Worker::pin_down(Call call, std::uint32_t level, std::uint32_t format, std::uint64_t count,
                      Misbehaved& found) {
  // The inputs are still in this process's mapping of the memory that the dead one shared.
  const auto again = inputs(call, count, found.first, found.count);
  try {
    stop();
    start();
    put(call, again);
    mailbox_->call = call;
    mailbox_->level = level;
    mailbox_->format = format;
    mailbox_->count = found.count;
    mailbox_->one_by_one = 1;
    if (exchange() && mailbox_->outcome == Outcome::answered)
      return;  // not again: the batch is all that can be named
    const bool spoke = pid_ > 0 && !hung_ && over_.empty();
    found.first += spoke ? mailbox_->element : mailbox_->begun.load();
    found.count = 1;
    found.alone = over_.empty() && (!spoke || mailbox_->outcome == Outcome::threw);
  } catch (const NoResources&) {
    throw;
  } catch (const std::runtime_error&) {
  }
}

std::string Worker::misdeed() const {
  const std::string message = mailbox_->message;
  switch (mailbox_->outcome) {
    case Outcome::threw:
      return message.empty() ? "threw an exception" : "threw an exception: " + message;
    case Outcome::changed_mode:
      return "left the rounding or flush mode changed";
    case Outcome::wrote_before:
      return "wrote before the start of its output";
    case Outcome::unwritten:
      return "left its output unwritten";
    case Outcome::non_deterministic:
      return "non-deterministic, " + message;
    case Outcome::too_large:
      return message;
    case Outcome::answered:
    case Outcome::ready:
    case Outcome::cannot_load:
    case Outcome::not_here:
      break;
  }
  return {};
}

void Worker::ask_of_this_level_alone(Call call, std::uint32_t level, std::uint64_t count,
                                     std::uint32_t format) {
  const auto again = inputs(call, count, 0, count);
  this_level_alone_[static_cast<std::size_t>(call)] = true;
  stop();
  start();
  put(call, again);
  ask(call, level, count, format);
}

std::pair<std::uint64_t, std::uint64_t> Worker::called_with(std::uint64_t element,
                                                            std::uint64_t count) const {
  const bool large = (description().flags & MMVERIFY_LARGE_BATCHES) != 0;
  const std::uint64_t most = large ? large_batch_size : batch_size, first = element / most * most;
  return {first, std::min(most, count - first)};
}

void Worker::ask(Call call, std::uint32_t level, std::uint64_t count, std::uint32_t format) {
  mailbox_->call = call;
  mailbox_->level = level;
  mailbox_->format = format;
  mailbox_->count = count;
  mailbox_->one_by_one = 0;
  mailbox_->this_level_alone = this_level_alone_[static_cast<std::size_t>(call)] ? 1 : 0;
  mailbox_->another_level.store(0);
  mailbox_->message[0] = 0;
  const bool answered = exchange();
  if (mailbox_->another_level.load() != 0) return ask_of_this_level_alone(call, level, count, format);
  Misbehaved found{{}, 0, 0};
  if (!answered) {
    found.what = why_no_answer();
    found.hung = hung_;
    std::tie(found.first, found.count) = called_with(mailbox_->begun.load(), count);
    pin_down(call, level, format, count, found);
    throw found;
  }
  found.what = misdeed();
  const std::uint64_t element = mailbox_->element;
  switch (mailbox_->outcome) {
    case Outcome::answered:
    case Outcome::ready:
    case Outcome::cannot_load:
    case Outcome::not_here:
      return;
    case Outcome::unwritten:
    case Outcome::non_deterministic:
      throw Misbehaved{found.what, element, 1};
    default:
      break;
  }
  std::tie(found.first, found.count) = called_with(element, count);
  pin_down(call, level, format, count, found);
  throw found;
}

Reply Worker::ask(const Question& q) {
  mailbox_->call = q.call;
  mailbox_->level = q.level;
  mailbox_->format = q.format;
  mailbox_->count = q.count;
  mailbox_->one_by_one = 0;
  mailbox_->blob_bytes = q.blob.size();
  mailbox_->room = q.room;
  mailbox_->asked_before = asked_[{q.call, q.level, q.format}]++;
  mailbox_->message[0] = 0;
  if (!q.blob.empty()) std::memcpy(base_ + layout_.blob_at(q.blob.size()), q.blob.data(), q.blob.size());
  if (!exchange()) throw Misbehaved{why_no_answer(), 0, q.count, hung_};
  if (mailbox_->outcome == Outcome::unwritten || mailbox_->outcome == Outcome::non_deterministic)
    throw Misbehaved{misdeed(), mailbox_->element, q.count == 0 ? 0u : 1u};
  if (mailbox_->outcome != Outcome::answered) throw Misbehaved{misdeed(), 0, q.count};
  const auto size = static_cast<std::size_t>(mailbox_->answer_bytes);
  return {mailbox_->taken != 0,
          {reinterpret_cast<const std::uint8_t*>(base_ + layout_.blob_answer_at(size)), size}};
}

}  // namespace mmverify::dock
