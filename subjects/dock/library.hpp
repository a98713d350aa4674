// A shared library: its workers, and the facts that its subjects of all topics share.
#pragma once

#include <memory>
#include <string>

#include "subjects/dock/clean_text.hpp"
#include "subjects/dock/known_breaks.hpp"
#include "subjects/dock/worker.hpp"

namespace mmverify::dock {

/// A worker from the pool. It goes back only if it answered; otherwise another takes its place.
class Borrowed {
 public:
  explicit Borrowed(Pool& pool) : pool_(pool), worker_(pool.take()) {}
  ~Borrowed() {
    if (worker_) try {
        pool_.replace(std::move(worker_));
      } catch (const std::bad_alloc&) {  // the next worker then repeats its first questions in every way
      }
  }
  Borrowed(Borrowed&&) = default;
  Worker& operator*() const { return *worker_; }
  Worker* operator->() const { return worker_.get(); }
  void give_back() { pool_.give_back(std::move(worker_)); }

 private:
  Pool& pool_;
  std::unique_ptr<Worker> worker_;
};

class Library {
 public:
  /// Throws CannotLoad if the file is no subject, NotHere if it says that it cannot run here,
  /// std::runtime_error if no process can be started.
  Library(const std::string& path, const Options& options);

  /// The subjects' name: Options::called, or the library's path.
  const std::string& path() const { return path_; }
  const Description& description() const { return description_; }
  bool offers(Call call) const { return description_.has[static_cast<std::size_t>(call)] != 0; }
  /// Whether it has an entry point of the topic.
  bool offers(Topic topic) const;
  /// The subject's lines KEY: VALUE about where it runs; empty if it gives none.
  std::string runs_on() const { return clean_lines(description_.runs_on); }
  /// The subject's own name, or "a shared library".
  std::string about() const {
    return description_.name[0] != 0 ? clean_text(description_.name) : "a shared library";
  }
  /// The file's size and a checksum.
  const std::string& fingerprint() const { return fingerprint_; }
  /// A sentence on how the file has changed since it was read; empty if it has not.
  std::string change() const { return pool_.file().change(); }
  Pool& pool() const { return pool_; }
  KnownBreaks& known_breaks() const { return known_breaks_; }

 private:
  mutable Pool pool_;
  mutable KnownBreaks known_breaks_;
  Description description_{};
  std::string path_, fingerprint_;
};
using LibraryPtr = std::shared_ptr<const Library>;

}  // namespace mmverify::dock
