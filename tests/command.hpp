// Runs the built program the way a script does: arguments in, exit code, stdout and stderr out.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/folder.hpp"

namespace mmverify::tests {

struct Outcome {
  int exit_code = -1;  ///< 128 + the signal that ended it, as a shell has it
  std::string out, err;
};

/// A program under way.
class Process {
 public:
  explicit Process(std::vector<std::string> arguments) {
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, (captured_ / "out").c_str(), O_WRONLY | O_CREAT,
                                     0600);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, (captured_ / "err").c_str(), O_WRONLY | O_CREAT,
                                     0600);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const int error = posix_spawn(&pid_, argv[0], &files, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) throw std::runtime_error(arguments[0] + " cannot be started");
  }
  ~Process() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  void send(int signal) const { ::kill(pid_, signal); }
  pid_t pid() const { return pid_; }

  /// Waits until stdout or stderr holds the words; false once the process has ended without them, or after
  /// ten minutes.
  bool says(const std::string& words) const {
    for (int tries = 0; tries < 60'000; ++tries) {
      siginfo_t state{};
      waitid(P_PID, static_cast<id_t>(pid_), &state, WEXITED | WNOHANG | WNOWAIT);
      for (const std::filesystem::path& stream : {captured_ / "out", captured_ / "err"})
        if (text_of(stream).find(words) != std::string::npos) return true;
      if (state.si_pid != 0) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  Outcome wait() {
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(captured_ / "out"),
            text_of(captured_ / "err")};
  }

 private:
  Folder captured_;
  pid_t pid_ = -1;
};

/// The processes that a process started and that still are, zombies too.
inline std::vector<pid_t> children_of(pid_t parent) {
  std::vector<pid_t> all;
  std::error_code gone;
  for (const auto& thread :
       std::filesystem::directory_iterator("/proc/" + std::to_string(parent) + "/task", gone)) {
    std::istringstream children(text_of(thread.path() / "children"));
    for (pid_t child = 0; children >> child;) all.push_back(child);
  }
  return all;
}

inline std::vector<std::string> program_with(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), MMVERIFY_PROGRAM);
  return arguments;
}

inline Outcome program(const std::vector<std::string>& arguments) {
  return Process(program_with(arguments)).wait();
}

/// A line as a person pastes it into a shell that finds mmverify on its PATH.
inline Outcome shell(const std::string& line) {
  const std::string folder = fs::path(MMVERIFY_PROGRAM).parent_path();
  return Process({"/bin/sh", "-c", "PATH=\"$1:$PATH\"; " + line, "sh", folder}).wait();
}

/// All that a failed command says: one line on stderr that names the program, nothing on stdout.
inline void expect_complaint(const Outcome& outcome, int exit_code, const std::string& words) {
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.starts_with("mmverify: ")) << outcome.err;
  EXPECT_EQ(outcome.err.find('\n'), outcome.err.size() - 1) << outcome.err;
  EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
}

}  // namespace mmverify::tests
