#include "cli/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "cli/exit_code.hpp"

extern char** environ;

namespace mmverify::cli {
namespace {

struct Closes {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closes>;

File temporary() {
  File file(std::tmpfile());
  if (!file) throw EnvironmentError(fmt::format("gnuplot: no temporary file: {}", std::strerror(errno)));
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

}  // namespace

std::string run_gnuplot(const std::string& script) {
  // Files, not pipes: neither side can wait for the other.
  const File in = temporary(), out = temporary(), complaints = temporary();
  if (std::fwrite(script.data(), 1, script.size(), in.get()) != script.size() || std::fflush(in.get()) != 0)
    throw EnvironmentError(fmt::format("gnuplot: its script cannot be written: {}", std::strerror(errno)));
  std::rewind(in.get());

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, fileno(in.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(complaints.get()), STDERR_FILENO);
  char program[] = "gnuplot";
  char* const arguments[] = {program, nullptr};
  pid_t child = 0;
  const int spawned = posix_spawnp(&child, program, &files, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&files);
  if (spawned == ENOENT)
    throw EnvironmentError("--plot needs gnuplot, which is not here: install the Debian package gnuplot-nox");
  if (spawned != 0) throw EnvironmentError(fmt::format("gnuplot: {}", std::strerror(spawned)));

  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw EnvironmentError(fmt::format("gnuplot: {}", std::strerror(errno)));
  std::string picture = contents(out);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || picture.find("</svg>") == std::string::npos)
    throw EnvironmentError(fmt::format("gnuplot drew nothing: {}", contents(complaints)));
  return picture;
}

}  // namespace mmverify::cli
