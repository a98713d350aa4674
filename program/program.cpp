#include "program/program.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
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

extern char** environ;

namespace mmverify::program {
namespace {

struct Closes {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closes>;

/// A file without a name, which the program does not inherit but as one of its three streams.
File nameless_file(const std::string& program) {
  File file(std::tmpfile());
  if (!file || fcntl(fileno(file.get()), F_SETFD, FD_CLOEXEC) != 0)
    throw std::runtime_error(program + ": no temporary file: " + std::strerror(errno));
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

void bound(pid_t child, const Bounds& bounds) {
  const auto at_most = [child](auto resource, rlim_t most) {
    const rlimit limit{most, most};
    prlimit(child, resource, &limit, nullptr);
  };
  at_most(RLIMIT_AS, bounds.memory);
  at_most(RLIMIT_FSIZE, bounds.a_file);
  at_most(RLIMIT_CORE, 0);
}

/// A program that runs; it is ended where nobody has waited for it.
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

  /// Its status, once it has one.
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
                       const std::function<void()>& stop, const Bounds& bounds) {
  const std::string& program = arguments.at(0);
  // Files, not pipes: neither side can wait for the other.
  const File in = nameless_file(program), out = nameless_file(program), errors = nameless_file(program);
  if (std::fwrite(input.data(), 1, input.size(), in.get()) != input.size() || std::fflush(in.get()) != 0)
    throw std::runtime_error(program + ": its input cannot be written: " + std::strerror(errno));
  std::rewind(in.get());

  std::vector<std::string> words = arguments;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, fileno(in.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(errors.get()), STDERR_FILENO);
  pid_t child = 0;
  const int spawned = posix_spawnp(&child, argv[0], &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (spawned == ENOENT) throw NoProgram(program + ": there is no program of that name");
  if (spawned != 0) throw std::runtime_error(program + ": " + std::strerror(spawned));

  Running running(child);
  bound(child, bounds);
  const auto begun = std::chrono::steady_clock::now();
  int status = 0;
  while (!running.ended(status)) {
    if (stop) stop();
    if (std::chrono::steady_clock::now() - begun > bounds.time)
      return {false, false, "stopped after " + std::to_string(bounds.time.count()) + " s", {}, {}};
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  // Ctrl-C ends the program as well: that is no fault of its own.
  if (stop) stop();
  return {WIFEXITED(status) && WEXITSTATUS(status) == 0, WIFEXITED(status),
          WIFEXITED(status) ? "exit code " + std::to_string(WEXITSTATUS(status))
                            : "signal " + std::to_string(WTERMSIG(status)),
          contents(out), contents(errors)};
}

}  // namespace mmverify::program
