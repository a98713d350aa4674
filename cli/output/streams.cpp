#include "cli/output/streams.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <csignal>

#include "cli/output/exit_code.hpp"
#include "proofs/engine/standard_error.hpp"

namespace mmverify::cli {
namespace {

bool reader_is_gone() {
  pollfd out{STDOUT_FILENO, POLLOUT, 0};
  return poll(&out, 1, 0) == 1 && (out.revents & (POLLERR | POLLHUP)) != 0;
}

}  // namespace

void reserve_standard_streams() {
  // open() takes the lowest free descriptor, so this fills the gaps below STDERR_FILENO.
  int opened = 0;
  while (opened >= 0 && opened <= STDERR_FILENO) opened = open("/dev/null", O_RDWR);
  if (opened > STDERR_FILENO) close(opened);
}

void end_with_the_reader() { std::signal(SIGPIPE, SIG_DFL); }

void say_text(std::FILE* out, std::string_view text) noexcept {
  if (out == stderr)
    proofs::to_standard_error(text);
  else
    std::fwrite(text.data(), 1, text.size(), out);
}

int after_printing(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
  if (reader_is_gone()) return code;
  say_text(stderr, "mmverify: standard output cannot be written\n");
  return code == ExitCode::complete ? ExitCode::environment : code;
}

}  // namespace mmverify::cli
