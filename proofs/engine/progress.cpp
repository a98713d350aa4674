#include "proofs/engine/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <system_error>

#include "proofs/engine/standard_error.hpp"

namespace mmverify::proofs {
using namespace std::chrono_literals;

Progress::Progress(std::uint64_t total, bool shown)
    : total_(total), terminal_(isatty(STDERR_FILENO) != 0), start_(std::chrono::steady_clock::now()) {
  if (!shown) return;
  try {
    watcher_ = std::thread([this] { watch(); });
  } catch (const std::system_error&) {
    // Without a thread for it, as in WebAssembly, nothing is shown.
  }
}

Progress::~Progress() {
  {
    const std::lock_guard hold(lock_);
    over_ = true;
  }
  wake_.notify_all();
  if (watcher_.joinable()) watcher_.join();
  if (drawn_ && terminal_) to_standard_error("\r\033[K");
}

void Progress::now(const std::string& what) {
  const std::lock_guard hold(lock_);
  what_ = what;
}

void Progress::watch() {
  const auto pause = terminal_ ? 200ms : 5000ms;
  std::unique_lock hold(lock_);
  while (!wake_.wait_for(hold, pause, [this] { return over_; })) show();
}

void Progress::show() {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double done = static_cast<double>(done_.load(std::memory_order_relaxed));
  const double total = static_cast<double>(total_), resumed = static_cast<double>(resumed_.load());
  const double share = total_ == 0 ? 1.0 : std::min(1.0, (done + resumed) / total);
  const double rate = done / seconds;
  const std::string eta = rate > 0 ? fmt::format("{:.0f} s", std::max(0.0, total - resumed - done) / rate)
                                   : std::string("unknown");
  const std::string numbers =
      fmt::format("{:3.0f} %  {:.1f} M cases/s  ETA {}  {}", 100 * share, rate / 1e6, eta, what_);
  if (terminal_) {
    constexpr std::size_t width = 24;
    const auto full = static_cast<std::size_t>(share * width);
    to_standard_error(
        fmt::format("\r\033[K[{}{}] {}", std::string(full, '#'), std::string(width - full, '.'), numbers));
  } else {
    to_standard_error(fmt::format("progress: {}\n", numbers));
  }
  drawn_ = true;
}

}  // namespace mmverify::proofs
