#include "dock/watch.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "dock/broken.hpp"

namespace mmverify::dock {

Printed::Printed() {
  if (pipe2(ends_, O_CLOEXEC) != 0)
    throw NoResources(fmt::format("cannot get a pipe for a worker: {}", std::strerror(errno)));
  fcntl(ends_[0], F_SETFL, O_NONBLOCK);
}

Printed::~Printed() {
  pass_on();
  for (const int end : ends_)
    if (end >= 0) close(end);
}

void Printed::close_write_end() {
  close(ends_[1]);
  ends_[1] = -1;
}

bool Printed::pass_on() {
  char text[1 << 16];
  while (bytes_ <= most) {
    const ssize_t got = read(ends_[0], text, sizeof text);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return true;
    bytes_ += static_cast<std::uint64_t>(got);
    look_for_report({text, static_cast<std::size_t>(got)});
    for (ssize_t at = 0; at < got;) {
      const ssize_t wrote = write(STDERR_FILENO, text + at, static_cast<std::size_t>(got - at));
      if (wrote < 0 && errno == EINTR) continue;
      if (wrote <= 0) break;  // nobody reads it
      at += wrote;
    }
  }
  return false;
}

void Printed::look_for_report(std::string_view text) {
  constexpr std::string_view begins = "SUMMARY: ";
  constexpr std::size_t longest = 400;
  for (const char c : text) {
    if (c == '\n') {
      if (line_.starts_with(begins)) report_ = line_.substr(begins.size());
      // UBSan's of g++ ends with no summary.
      if (report_.empty() && line_.find(": runtime error: ") != std::string::npos) report_ = line_;
      line_.clear();
    } else if (line_.size() < longest) {
      line_ += c;
    }
  }
}

Bounds bounds() {
  Bounds bounds;
  if (const char* text = std::getenv("MMVERIFY_WORKER_MEMORY")) {
    char* end = nullptr;
    errno = 0;
    bounds.memory_mib = std::strtoull(text, &end, 10);
    if (*text < '0' || *text > '9' || *end != 0 || errno != 0 || bounds.memory_mib == 0)
      throw std::runtime_error(
          fmt::format("MMVERIFY_WORKER_MEMORY: '{}' is not a number of MiB from 1 on", text));
  }
  return bounds;
}

std::string over(const Bounds& bounds, int pid) {
  std::ifstream status(fmt::format("/proc/{}/status", pid));
  std::string name, rest;
  for (std::uint64_t value = 0; status >> name; std::getline(status, rest)) {
    if (name == "VmRSS:" && status >> value && value / 1024 > bounds.memory_mib)
      return fmt::format("took more than {} MiB of memory", bounds.memory_mib);
    if (name == "Threads:" && status >> value && value > bounds.threads)
      return fmt::format("had more than {} threads", bounds.threads);
  }
  return {};
}

}  // namespace mmverify::dock
