#include "shaders/compile/run_program.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

extern char** environ;

namespace mmverify::shaders {

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
    char text[1 << 14];
    for (ssize_t got = 0; (got = read(ends[0], text, sizeof text)) > 0 || (got < 0 && errno == EINTR);)
      if (got > 0) ran.printed.append(text, static_cast<std::size_t>(got));
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) continue;
    constexpr int by_signal = 128;
    ran.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : by_signal + WTERMSIG(status);
  }
  close(ends[0]);
  if (error != 0 && error != ENOENT)
    throw std::runtime_error(words[0] + " cannot be started: " + std::strerror(error));
  return ran;
}

}  // namespace mmverify::shaders
