#include "subjects/dock/library.hpp"

namespace mmverify::dock {

Library::Library(const std::string& path, const Options& options)
    : pool_(path, options),
      path_(options.called.empty() ? path : options.called),
      fingerprint_(options.fingerprint.empty() ? pool_.file().fingerprint() : options.fingerprint) {
  Borrowed worker(pool_);
  description_ = worker->description();
  worker.give_back();
}

bool Library::offers(Topic topic) const {
  for (std::size_t c = 0; c < calls; ++c)
    if (description_.has[c] != 0 && entry_points[c].topic == topic) return true;
  return false;
}

}  // namespace mmverify::dock
