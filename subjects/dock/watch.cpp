#include "subjects/dock/watch.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "subjects/dock/broken.hpp"
#include "subjects/dock/clean_text.hpp"

namespace mmverify::dock {

Printed::Printed() {
  if (pipe2(ends_, O_CLOEXEC) != 0)
    throw NoResources(fmt::format("cannot get a pipe for a worker: {}", std::strerror(errno)));
  fcntl(ends_[0], F_SETFL, O_NONBLOCK);
}

Printed::~Printed() {
  pass_on();
  if (!line_.empty()) end_line();
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
    take({text, static_cast<std::size_t>(got)});
  }
  return false;
}

void Printed::take(std::string_view text) {
  constexpr std::size_t longest = 4096;
  for (const char c : text) {
    if (c != '\n') line_ += c;
    if (c == '\n' || line_.size() == longest) end_line();
  }
}

void Printed::end_line() {
  constexpr std::string_view begins = "SUMMARY: ";
  constexpr std::size_t longest_report = 400;
  const std::string line = clean_text(line_);
  line_.clear();
  if (line.starts_with(begins)) report_ = line.substr(begins.size(), longest_report);
  // A report of g++'s UBSan has no summary at its end.
  if (report_.empty() && line.find(": runtime error: ") != std::string::npos)
    report_ = line.substr(0, longest_report);
  const std::string marked = "subject| " + line + "\n";
  for (std::size_t at = 0; at < marked.size();) {
    const ssize_t wrote = write(STDERR_FILENO, marked.data() + at, marked.size() - at);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) break;  // nobody reads it
    at += static_cast<std::size_t>(wrote);
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
  std::uint64_t kib = 0;
  for (std::uint64_t value = 0; status >> name; std::getline(status, rest)) {
    // A resident set excludes huge pages from a pool, and swapped memory.
    if ((name == "VmRSS:" || name == "VmSwap:" || name == "HugetlbPages:") && status >> value) kib += value;
    if (name == "Threads:" && status >> value && value > bounds.threads)
      return fmt::format("had more than {} threads", bounds.threads);
  }
  if (kib / 1024 > bounds.memory_mib)
    return fmt::format("took more than {} MiB of memory", bounds.memory_mib);
  // Files may be memory: in /dev/shm, and on many machines in /tmp.
  std::ifstream io(fmt::format("/proc/{}/io", pid));
  for (std::uint64_t value = 0; io >> name >> value;)
    if (name == "wchar:" && value >> 20 > bounds.memory_mib)
      return fmt::format("wrote more than {} MiB to files", bounds.memory_mib);
  return {};
}

char state_of(int pid) {
  std::ifstream status(fmt::format("/proc/{}/status", pid));
  std::string name, rest;
  for (char state = 0; status >> name; std::getline(status, rest))
    if (name == "State:" && status >> state) return state;
  return 0;
}

double Waiting::seconds() {
  constexpr int most_threads = 16;
  std::uint64_t longest = 0;
  std::error_code error;
  std::filesystem::directory_iterator at(fmt::format("/proc/{}/task", pid_), error);
  for (int k = 0; !error && at != std::filesystem::directory_iterator() && k < most_threads;
       at.increment(error), ++k) {
    std::ifstream file(at->path() / "schedstat");
    std::uint64_t ran = 0, waited = 0;
    if (!(file >> ran >> waited)) continue;
    std::uint64_t& before = nanoseconds_[at->path().filename().string()];
    longest = std::max(longest, waited - before);
    before = waited;
  }
  return 1e-9 * static_cast<double>(longest);
}

}  // namespace mmverify::dock
