#include "proofs/engine/standard_error.hpp"

#include <poll.h>
#include <unistd.h>

#include <cerrno>

namespace mmverify::proofs {

void to_standard_error(std::string_view text) noexcept {
  constexpr int patience_ms = 1000;  // for a terminal whose other users have made it non-blocking
  while (!text.empty()) {
    const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    if (written > 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
      continue;
    }
    if (written < 0 && errno == EINTR) continue;
    pollfd until_it_takes_more{STDERR_FILENO, POLLOUT, 0};
    if (written == 0 || errno != EAGAIN || poll(&until_it_takes_more, 1, patience_ms) <= 0) return;
  }
}

}  // namespace mmverify::proofs
