#include "subjects/dock/library_file.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <cstdint>
#include <fstream>
#include <utility>

namespace mmverify::dock {
namespace {

std::string fingerprint_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  boost::crc_32_type crc;
  std::uint64_t size = 0;
  for (char block[1 << 16]; in.read(block, sizeof block), in.gcount() > 0;) {
    crc.process_bytes(block, static_cast<std::size_t>(in.gcount()));
    size += static_cast<std::uint64_t>(in.gcount());
  }
  return fmt::format("({} bytes, crc {:08x})", size, crc.checksum());
}

struct stat about(const std::string& file) {
  struct stat found {};
  if (stat(file.c_str(), &found) != 0) found = {};
  return found;
}

bool same_time(const timespec& a, const timespec& b) {
  return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
}

bool untouched(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino && a.st_size == b.st_size &&
         same_time(a.st_mtim, b.st_mtim) && same_time(a.st_ctim, b.st_ctim);
}

}  // namespace

// The times are read first, so that a write in between is noticed later.
LibraryFile::LibraryFile(std::string path) : path_(std::move(path)) {
  about_ = about(path_);
  fingerprint_ = fingerprint_of(path_);
}

std::string LibraryFile::change() const {
  if (untouched(about_, about(path_))) return {};
  const std::string now = fingerprint_of(path_);
  if (now == fingerprint_) return {};
  return fmt::format(
      "{} was changed during the run, from {} to {}: no verdict is said of either; run it again", path_,
      fingerprint_, now);
}

}  // namespace mmverify::dock
