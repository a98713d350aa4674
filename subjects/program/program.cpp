#include "subjects/program/program.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>
#include <thread>

namespace mmverify::program {
namespace {

struct Closes {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closes>;

/// A file without a name, in memory: it needs no folder for temporary files and no room in one. The program
/// inherits it only as one of its three streams.
File nameless_file(const std::string& program) {
  const int memory = memfd_create("mmverify", MFD_CLOEXEC);
  File file(memory < 0 ? nullptr : fdopen(memory, "w+"));
  if (!file) throw std::runtime_error(program + ": no temporary file: " + std::strerror(errno));
  return file;
}

std::string contents(const File& file) {
  std::rewind(file.get());
  std::string text;
  std::array<char, 4096> part;
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), file.get()))
    text.append(part.data(), n);
  return text;
}

/// The part of a file from a byte on. The place where the program that writes it goes on stays.
std::string contents_from(const File& file, std::size_t begin) {
  std::string text;
  std::array<char, 4096> part;
  for (;;) {
    const ssize_t n =
        pread(fileno(file.get()), part.data(), part.size(), static_cast<off_t>(begin + text.size()));
    if (n <= 0) return text;
    text.append(part.data(), static_cast<std::size_t>(n));
  }
}

void bound(const Bounds& bounds) {
  const auto at_most = [](auto resource, rlim_t most) {
    const rlimit limit{most, most};
    setrlimit(resource, &limit);
  };
  at_most(RLIMIT_AS, bounds.memory);
  at_most(RLIMIT_FSIZE, bounds.a_file);
  at_most(RLIMIT_CORE, 0);
}

/// A pipe whose ends no other program inherits.
class Pipe {
 public:
  Pipe() {
    if (pipe2(ends_, O_CLOEXEC) != 0) throw std::runtime_error(std::string("pipe: ") + std::strerror(errno));
  }
  ~Pipe() {
    close(ends_[0]);
    if (ends_[1] >= 0) close(ends_[1]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  void tell(int number) const {
    while (write(ends_[1], &number, sizeof number) < 0 && errno == EINTR) continue;
  }
  /// The number that the other end sent, or 0 if that end was closed without sending one.
  int told() {
    close(ends_[1]);
    ends_[1] = -1;
    int number = 0;
    while (read(ends_[0], &number, sizeof number) < 0 && errno == EINTR) continue;
    return number;
  }

 private:
  int ends_[2];
};

/// Starts a program with its three streams, bounded before its first instruction. Returns 0, or errno of the
/// failure. After fork() it makes system calls only: another thread may have held a lock.
int start(char* const* argv, const std::array<int, 3>& streams, const Bounds& bounds, pid_t& child) {
  Pipe failure;
  child = fork();
  if (child < 0) return errno;
  if (child == 0) {
    bool placed = true;
    for (int stream = 0; stream < 3; ++stream) {
      const int file = streams[static_cast<std::size_t>(stream)];
      // If our own stream was closed, the file may have its number already, and exec would close it.
      placed = placed && (file == stream ? fcntl(file, F_SETFD, 0) == 0 : dup2(file, stream) >= 0);
    }
    if (placed) {
      bound(bounds);
      signal(SIGPIPE, SIG_DFL);  // exec keeps the signals that we ignore
      execvp(argv[0], argv);
    }
    failure.tell(errno);
    _exit(127);
  }
  const int error = failure.told();
  if (error != 0)
    while (waitpid(child, nullptr, 0) < 0 && errno == EINTR) continue;
  return error;
}

/// A running program; the destructor ends it unless it has ended.
class Running {
 public:
  explicit Running(pid_t child) : child_(child) {}
  ~Running() {
    if (child_ == 0) return;
    kill(child_, SIGTERM);
    for (int waits = 0; waits < 100; ++waits) {
      if (waitpid(child_, nullptr, WNOHANG) != 0) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    kill(child_, SIGKILL);
    while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) continue;
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  /// Whether it has ended; then `status` is its status.
  bool ended(int& status) {
    const pid_t done = waitpid(child_, &status, WNOHANG);
    if (done < 0 && errno != EINTR) throw std::runtime_error(std::string("waitpid: ") + std::strerror(errno));
    if (done <= 0) return false;
    child_ = 0;
    return true;
  }

 private:
  pid_t child_;
};

}  // namespace

ProgramEnd run_program(const std::vector<std::string>& arguments, const std::string& input,
                       const std::function<void()>& stop, const Bounds& bounds,
                       const std::function<void(const std::string&)>& heard) {
  const std::string& program = arguments.at(0);
  // Files, not pipes: a full pipe would let each side wait for the other.
  const File in = nameless_file(program), out = nameless_file(program), errors = nameless_file(program);
  if (std::fwrite(input.data(), 1, input.size(), in.get()) != input.size() || std::fflush(in.get()) != 0)
    throw std::runtime_error(program + ": its input cannot be written: " + std::strerror(errno));
  std::rewind(in.get());

  std::vector<std::string> words = arguments;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  const int error =
      start(argv.data(), {fileno(in.get()), fileno(out.get()), fileno(errors.get())}, bounds, child);
  if (error == ENOENT) throw NoProgram(program + ": there is no program of that name");
  if (error != 0) throw std::runtime_error(program + ": " + std::strerror(error));

  Running running(child);
  const auto begun = std::chrono::steady_clock::now();
  std::size_t said = 0;
  const auto hear = [&] {
    const std::string more = heard ? contents_from(out, said) : std::string();
    said += more.size();
    if (!more.empty()) heard(more);
  };
  int status = 0;
  while (!running.ended(status)) {
    if (stop) stop();
    hear();
    if (std::chrono::steady_clock::now() - begun > bounds.time)
      return {false, false, "stopped after " + std::to_string(bounds.time.count()) + " s", {}, {}};
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  // Ctrl-C ends the program as well, which is no failure of the program.
  if (stop) stop();
  hear();
  return {WIFEXITED(status) && WEXITSTATUS(status) == 0, WIFEXITED(status),
          WIFEXITED(status) ? "exit code " + std::to_string(WEXITSTATUS(status))
                            : "signal " + std::to_string(WTERMSIG(status)),
          contents(out), contents(errors)};
}

}  // namespace mmverify::program
