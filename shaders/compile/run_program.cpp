#include "shaders/compile/run_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>

extern char** environ;

namespace mmverify::shaders {
namespace {

constexpr std::size_t most_printed = std::size_t{64} << 20;

/// A compiler that a hostile file keeps busy, one that includes itself, ends by itself.
void bound(pid_t pid) {
  const auto at_most = [pid](auto resource, rlim_t most) {
    const rlimit limit{most, most};
    prlimit(pid, resource, &limit, nullptr);
  };
  at_most(RLIMIT_CPU, most_seconds);
  at_most(RLIMIT_AS, rlim_t{1} << 30);
  at_most(RLIMIT_FSIZE, rlim_t{256} << 20);
  at_most(RLIMIT_CORE, 0);
}

}  // namespace

Ran run_program(const std::vector<std::string>& words) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw std::runtime_error(std::string("cannot get a pipe: ") + std::strerror(errno));
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  pid_t pid = -1;
  const int error = posix_spawnp(&pid, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  Ran ran;
  if (error == 0) {
    ran.found = true;
    bound(pid);
    bool stopped = false;
    char text[1 << 14];
    for (ssize_t got = 0; (got = read(ends[0], text, sizeof text)) > 0 || (got < 0 && errno == EINTR);) {
      if (got > 0) ran.printed.append(text, static_cast<std::size_t>(got));
      if (ran.printed.size() > most_printed && !stopped) stopped = kill(pid, SIGKILL) == 0;
      if (stopped) ran.printed.clear();
    }
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) continue;
    constexpr int by_signal = 128;
    ran.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : by_signal + WTERMSIG(status);
    ran.stopped = stopped || WIFSIGNALED(status);
  }
  close(ends[0]);
  if (error != 0 && error != ENOENT)
    throw std::runtime_error(words[0] + " cannot be started: " + std::strerror(error));
  return ran;
}

}  // namespace mmverify::shaders
