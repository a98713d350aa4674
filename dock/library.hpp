// A shared library that was opened: its workers, and what its subjects of all topics have in common.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "dock/clean_text.hpp"
#include "dock/known_breaks.hpp"
#include "dock/worker.hpp"

namespace mmverify::dock {

/// A worker out of the pool; it goes back only if it answered, else another takes its place.
class Borrowed {
 public:
  explicit Borrowed(Pool& pool) : pool_(pool), worker_(pool.take()) {}
  ~Borrowed() {
    if (worker_) try {
        pool_.replace(std::move(worker_));
      } catch (const std::bad_alloc&) {  // the next worker asks its first questions in every way again
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
  /// Throws CannotLoad where the file is no subject, NotHere where it says that it cannot run here, std::runtime_error
  /// where no process can be had.
  Library(const std::string& path, const Options& options);

  /// What its subjects are called by: Options::called, or its path.
  const std::string& path() const { return path_; }
  const Description& description() const { return description_; }
  bool offers(Call call) const { return description_.has[static_cast<std::size_t>(call)] != 0; }
  /// Whether it has an entry point of the topic.
  bool offers(Topic topic) const;
  /// Where it runs, in lines KEY: VALUE; empty where it says nothing.
  std::string runs_on() const { return clean_lines(description_.runs_on); }
  /// What it calls itself.
  std::string about() const {
    return description_.name[0] != 0 ? clean_text(description_.name) : "a shared library";
  }
  /// The file's contents, in a word: its size and a checksum.
  const std::string& fingerprint() const { return fingerprint_; }
  /// What its file has become since, in a sentence; empty where it is the same.
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
