#include "dock/library.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <fstream>

namespace mmverify::dock {
namespace {

std::string fingerprint_of(const std::string& library) {
  std::ifstream in(library, std::ios::binary);
  boost::crc_32_type crc;
  std::uint64_t size = 0;
  for (char block[1 << 16]; in.read(block, sizeof block), in.gcount() > 0;) {
    crc.process_bytes(block, static_cast<std::size_t>(in.gcount()));
    size += static_cast<std::uint64_t>(in.gcount());
  }
  return fmt::format("({} bytes, crc {:08x})", size, crc.checksum());
}

}  // namespace

Library::Library(const std::string& path, const Options& options)
    : pool_(path, options),
      path_(options.called.empty() ? path : options.called),
      fingerprint_(options.fingerprint.empty() ? fingerprint_of(path) : options.fingerprint) {
  Borrowed worker(pool_);
  description_ = worker->description();
  worker.give_back();
}

bool Library::offers(Topic topic) const {
  for (std::size_t c = 0; c < calls; ++c)
    if (description_.has[c] && entry_points[c].topic == topic) return true;
  return false;
}

}  // namespace mmverify::dock
