#include "subjects/dock/worker.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>

#include "subjects/dock/broken.hpp"
#include "subjects/dock/clean_text.hpp"
#include "subjects/dock/description.hpp"
#include "subjects/dock/futex.hpp"
#include "subjects/dock/sanitizer.hpp"

namespace mmverify::dock {
namespace {

/// The program of workers: MMVERIFY_WORKER, or beside this program, or where it is installed.
std::string worker_program() {
  if (const char* named = std::getenv("MMVERIFY_WORKER")) return named;
  std::error_code error;
  const auto here = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  if (error)
    throw std::runtime_error(fmt::format(
        "/proc/self/exe, by which mmverify-worker is found, cannot be read: {}; mount /proc, or set "
        "MMVERIFY_WORKER to the worker's path",
        error.message()));
  for (const auto& place : {here / "mmverify-worker", here / "../libexec/mmverify/mmverify-worker"})
    if (std::filesystem::exists(place, error)) return place.string();
  throw std::runtime_error(
      fmt::format("mmverify-worker is not beside {}; set MMVERIFY_WORKER to its path", here.string()));
}

[[noreturn]] void fail(const char* what) {
  throw NoResources(fmt::format("{}: {}", what, std::strerror(errno)));
}

/// The bounds are checked once in `unwatched` questions that are answered fast; a wait checks them itself.
constexpr std::uint64_t unwatched = 256;

/// The interval at which a wait checks whether the process lives.
constexpr long slice_milliseconds = 20;

/// The fault of a worker whose report is impossible: only a subject that writes out of bounds can cause it.
constexpr char wrote_into_ours[] = "wrote into the tool's own memory";

/// Special values of processor_.
constexpr int anywhere = -1, not_asked = -2;

}  // namespace

Worker::Worker(std::string library, const Options& options, Before before)
    : library_(std::move(library)),
      options_(options),
      environment_(worker_environment(library_)),
      layout_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))),
      asked_(std::move(before.asked)),
      loaded_before_(before.loaded),
      file_(before.file) {
  environment_.insert(environment_.end(), options_.environment.begin(), options_.environment.end());
  try {
    start();
  } catch (...) {
    stop();
    throw;
  }
}

Worker::~Worker() { stop(); }

void Worker::start() {
  start_process();
  wait_until_loaded();
  if (file_ != nullptr)
    if (const std::string change = file_->change(); !change.empty()) throw NoResources(change);
  const std::string why = message_;
  switch (report_.outcome) {
    case Outcome::ready: loaded_before_ = true; return;
    case Outcome::not_here:
      if (!loaded_before_) throw NotHere(why);
      break;
    case Outcome::cannot_open:
      if (loaded_before_) throw NoResources(fmt::format("{}: {}", library_, why));
      break;
    case Outcome::starting:
      throw NoResources(fmt::format("cannot start mmverify-worker: it {}; too little memory?", why));
    default: break;
  }
  const std::string what = fmt::format("{}: {}", library_, why);
  if (loaded_before_) throw SubjectBroken(what + ", though it was loaded before");
  throw CannotLoad(what);
}

void Worker::start_process() {
  fd_ = memfd_create("mmverify-subject", MFD_CLOEXEC | MFD_ALLOW_SEALING);
  // The descriptors up to shared_memory_descriptor are the worker's.
  if (fd_ >= 0 && fd_ <= shared_memory_descriptor) {
    const int above = fcntl(fd_, F_DUPFD_CLOEXEC, shared_memory_descriptor + 1);
    close(fd_);
    fd_ = above;
  }
  if (fd_ < 0 || ftruncate(fd_, static_cast<off_t>(layout_.total())) != 0)
    fail("cannot get memory for a worker");
  // If the file were cut short under the mapping, reading there would raise SIGBUS.
  if (fcntl(fd_, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL) != 0)
    fail("cannot seal a worker's memory");
  base_ = static_cast<std::byte*>(mmap(nullptr, layout_.total(), PROT_READ | PROT_WRITE, MAP_SHARED, fd_, 0));
  if (base_ == MAP_FAILED) fail("cannot map a worker's memory");
  mailbox_ = reinterpret_cast<Mailbox*>(base_);
  mailbox_->turn.store(1);
  mailbox_->report.outcome = Outcome::starting;  // until the worker reports something else

  const std::string program = worker_program();
  std::string name = "mmverify-worker", library = std::filesystem::absolute(library_).string();
  char* argv[] = {name.data(), library.data(), nullptr};
  printed_ = std::make_unique<Printed>();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, printed_->write_end(), STDERR_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fd_, shared_memory_descriptor);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  // A process group of its own: whatever a subject forks ends with it, and Ctrl-C reaches only this process.
  // No session of its own: a kernel that shares processors among sessions would make the two wait for
  // everybody else's turn.
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
}

void Worker::wait_until_loaded() {
  const bool turned = wait_for_turn(options_.loading_seconds(), true);
  take_report();
  std::memcpy(&description_, &mailbox_->description, sizeof description_);
  if (!turned) {
    // At this point no code of the subject has run.
    const bool touched = report_.outcome != Outcome::starting;
    if (touched) report_.outcome = Outcome::cannot_load;
    message_ =
        hung_ ? fmt::format("hung: not done within {} s", options_.loading_seconds()) : why_no_answer();
    if (touched) message_ += " while it was loaded";
  } else if (!over_.empty() || !description_is_whole(description_) || report_.outcome > Outcome::not_here) {
    report_.outcome = Outcome::cannot_load;
    message_ = std::string(wrote_into_ours) + " while it was loaded";
  } else if (report_.outcome == Outcome::ready) {
    if (const std::string fault = description_fault(description_); !fault.empty()) {
      report_.outcome = Outcome::cannot_load;
      message_ = fault;
    }
  }
}

void Worker::stop() {
  if (pid_ > 0) {
    // The kill by number is needed too: MMVERIFY_UNCONFINED lets the process change its group.
    kill(-pid_, SIGKILL);
    kill(pid_, SIGKILL);
    while (waitpid(pid_, &status_, 0) < 0 && errno == EINTR) continue;
  }
  pid_ = -1;
  printed_.reset();
  if (base_ != nullptr && base_ != MAP_FAILED) munmap(base_, layout_.total());
  base_ = nullptr;
  if (fd_ >= 0) close(fd_);
  fd_ = -1;
}

bool Worker::ended() {
  siginfo_t how{};
  if (pid_ <= 0 || waitid(P_PID, static_cast<id_t>(pid_), &how, WEXITED | WNOHANG | WNOWAIT) != 0 ||
      how.si_pid != pid_)
    return false;
  status_ = how.si_code == CLD_EXITED ? how.si_status << 8 : how.si_status;
  // A confined subject cannot send this signal, and this process has not sent it.
  if (WIFSIGNALED(status_) && WTERMSIG(status_) == SIGKILL)
    throw NoResources(fmt::format(
        "mmverify-worker with {} was killed from outside; out of memory? No verdict is said of it",
        library_));
  return true;
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
  // If that is not allowed, the process runs elsewhere as well.
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
  bring_here();
  mailbox_->begun.store(0);
  mailbox_->report.message[0] = 0;
  mailbox_->turn.store(1, std::memory_order_release);
  futex_wake(mailbox_->turn);
  const bool turned = wait_for_turn(options_.timeout_seconds, false);
  take_report();
  if (!turned) return false;
  if (over_.empty() && !report_is_possible()) over_ = wrote_into_ours;
  if (!over_.empty()) return false;
  if (report_.outcome == Outcome::no_resources)
    throw NoResources(fmt::format("{} cannot be asked: {}", library_, message_));
  return ++questions_ % unwatched != 0 || within_bounds();
}

bool Worker::wait_for_turn(double seconds, bool loading) {
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;
  // The most time that counts between two checks: this process may have been stopped, and the worker with it.
  constexpr Seconds longest_look(10e-3 * slice_milliseconds);
  std::uint64_t calls = mailbox_->calls.load(std::memory_order_relaxed);
  auto last = Clock::now();
  // A busy machine is no fault of the subject: time without a processor does not count for a call.  Most calls end within
  // a slice, so nothing is read from the kernel for them.
  std::optional<Waiting> waiting;
  Seconds of_call(0), of_command(0);
  std::uint32_t turn = 0;
  while ((turn = mailbox_->turn.load(std::memory_order_acquire)) == 1) {
    futex_wait(mailbox_->turn, 1, slice_milliseconds);
    if ((turn = mailbox_->turn.load(std::memory_order_acquire)) != 1) break;
    options_.stop_if_asked();
    if (ended() || !within_bounds()) return false;
    const auto now = Clock::now();
    const Seconds look = std::min<Seconds>(now - last, longest_look);
    last = now;
    of_command += look;
    if (!waiting) waiting.emplace(pid_);
    of_call += std::max(Seconds(0), look - Seconds(waiting->seconds()));
    const std::uint64_t made = mailbox_->calls.load(std::memory_order_relaxed);
    const bool starting = static_cast<const volatile Report&>(mailbox_->report).outcome == Outcome::starting;
    if (loading ? starting : made != calls) {
      calls = made;
      of_call = Seconds(0);
    }
    if (of_call.count() <= seconds && of_command.count() <= options_.command_seconds()) continue;
    const char state = state_of(pid_);
    if (state == 'T')
      throw NoResources(fmt::format("mmverify-worker with {} was stopped from outside (SIGSTOP)", library_));
    if (state == 't') {  // stopped by a debugger
      of_call = Seconds(0);
      continue;
    }
    hung_ = true;
    return false;
  }
  if (turn != 0) over_ = wrote_into_ours;
  return true;
}

void Worker::take_report() {
  std::memcpy(&report_, &mailbox_->report, sizeof report_);
  // The compiler must not read the mailbox again later.
  std::atomic_signal_fence(std::memory_order_seq_cst);
  if (std::memchr(report_.message, 0, sizeof report_.message) == nullptr) {
    over_ = wrote_into_ours;
    report_.message[0] = 0;
  }
  message_ = clean_text(report_.message);
}

bool Worker::report_is_possible() const {
  if (report_.outcome < Outcome::answered || report_.outcome > Outcome::no_resources) return false;
  const Signature& signature = entry_point(sent_.call).signature;
  if (!signature.of_blob || report_.outcome != Outcome::answered) return true;
  if ((report_.taken != 0) != (report_.answer_bytes != 0)) return false;
  return signature.sizes_answer ? report_.answer_bytes <= blob_capacity
                                : report_.answer_bytes == 0 || report_.answer_bytes == sent_.room;
}

std::uint64_t Worker::begun() const {
  return std::min(mailbox_->begun.load(), std::max<std::uint64_t>(sent_.count, 1) - 1);
}

std::string Worker::end_of_process() {
  printed_->pass_on();
  if (WIFSIGNALED(status_)) {
    const int signal = WTERMSIG(status_);
    std::string why = message_;
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
  // The inputs are still in this process's mapping of the shared memory.
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
    sent_ = {call, found.count, 0};
    const bool spoke = exchange();
    if (spoke && report_.outcome == Outcome::answered) return;  // it answers now: only the batch can be named
    const std::uint64_t element = spoke ? report_.element : begun();
    if (element >= found.count) return;
    found.first += element;
    found.count = 1;
    found.alone = over_.empty() && (!spoke || report_.outcome == Outcome::threw);
  } catch (const NoResources&) {
    throw;
  } catch (const std::runtime_error&) {
  }
}

std::string Worker::misdeed() const {
  const std::string where = message_.empty() ? "" : " " + message_;
  switch (report_.outcome) {
    case Outcome::threw: return message_.empty() ? "threw an exception" : "threw an exception: " + message_;
    case Outcome::changed_mode: return "left the rounding or flush mode changed" + where;
    case Outcome::unmasked_exceptions: return "left floating-point exceptions unmasked" + where;
    case Outcome::left_registers: return "left values in the x87 or MMX registers" + where;
    case Outcome::changed_signals: return "left the signal mask changed" + where;
    case Outcome::wrote_before: return "wrote before the start of its output" + where;
    case Outcome::wrote_behind: return "wrote behind the end of its output" + where;
    case Outcome::unwritten: return "left its output unwritten";
    case Outcome::non_deterministic: return "non-deterministic, " + message_;
    case Outcome::changed_struct:
    case Outcome::too_large: return message_;
    default: break;
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
  sent_ = {call, count, 0};
  const bool answered = exchange();
  // This happens once: after that the worker asks about no other level.
  if (mailbox_->another_level.load() != 0 && !this_level_alone_[static_cast<std::size_t>(call)])
    return ask_of_this_level_alone(call, level, count, format);
  Misbehaved found{{}, 0, 0};
  if (!answered) {
    found.what = why_no_answer();
    found.hung = hung_;
    std::tie(found.first, found.count) = called_with(begun(), count);
    pin_down(call, level, format, count, found);
    throw found;
  }
  found.what = misdeed();
  const std::uint64_t element = report_.element;
  const bool known = element < count;
  switch (report_.outcome) {
    case Outcome::answered: return;
    case Outcome::unwritten:
    case Outcome::non_deterministic: throw Misbehaved{found.what, known ? element : 0, known ? 1 : count};
    default: break;
  }
  std::tie(found.first, found.count) = called_with(known ? element : 0, count);
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
  sent_ = {q.call, q.count, q.room};
  mailbox_->another_level.store(0);
  if (!q.blob.empty()) std::memcpy(base_ + layout_.blob_at(q.blob.size()), q.blob.data(), q.blob.size());
  if (!exchange()) {
    const bool beyond = mailbox_->another_level.load() != 0;
    throw Misbehaved{why_no_answer() + (beyond ? " (while an earlier question, or one of another level or "
                                                 "format, was repeated; that one may be at fault)"
                                               : ""),
                     0, q.count, hung_};
  }
  if (report_.outcome == Outcome::unwritten || report_.outcome == Outcome::non_deterministic)
    throw Misbehaved{misdeed(), report_.element < q.count ? report_.element : 0,
                     report_.element < q.count ? 1 : q.count};
  if (report_.outcome != Outcome::answered) throw Misbehaved{misdeed(), 0, q.count};
  const auto size = static_cast<std::size_t>(report_.answer_bytes);
  return {report_.taken != 0,
          {reinterpret_cast<const std::uint8_t*>(base_ + layout_.blob_answer_at(size)), size}};
}

}  // namespace mmverify::dock
