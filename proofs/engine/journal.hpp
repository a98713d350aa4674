// A file that a run adds to as it goes, so that it can be killed at any moment and go on later.
#pragma once

#include <chrono>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "proofs/engine/chunk.hpp"
#include "proofs/engine/tally.hpp"

namespace mmverify::proofs {

/// A journal that cannot be gone on with: another run's, damaged, in use, or no disk to write it to.  what()
/// names the file.
struct BadJournal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a run is about, item by item (name, value).  Two runs that agree on all of it do the same work.
using Identity = std::vector<std::pair<std::string, std::string>>;

/// The first item in which two identities differ, in words; empty where there is none.
std::string difference(const Identity& theirs, const Identity& ours);

/// Lines of text: a checksum and a JSON object each.  The first names the run, the others are finished pieces
/// of work. What a damaged line was about is done again.
class Journal {
 public:
  /// Opens or makes the file, and reads what is finished.  Throws BadJournal.
  Journal(std::string path, Identity identity);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// A finished piece: units [units.begin, units.end) of the `of` units of what `about` names.
  struct Piece {
    std::string about;
    Chunk units;
    std::uint64_t of = 0;
    Tally tally;
  };

  /// The pieces that the file held when it was opened, of one name and number of units, in order and
  /// disjoint.
  std::vector<Piece> finished(const std::string& about, std::uint64_t of) const;

  /// Appends a piece. It survives the death of this process at once, and that of the machine from the first
  /// append or flush on that comes a quarter of a second after the last. May be called from several threads.
  /// Throws BadJournal where it cannot be written; the file then ends with the last whole line.
  void append(const Piece& piece);

  /// Forgets all: what was found says nothing of the run any more.  Throws BadJournal.
  void discard();

  /// Writes through to the disk what has been appended.
  void flush();

  /// Bytes of the file that were in no whole line when it was opened.
  std::uint64_t dropped() const { return dropped_; }

 private:
  void read(const std::string& text);
  void write_line(const std::string& json);

  std::string path_;
  Identity identity_;
  int file_ = -1;
  std::uint64_t size_ = 0, dropped_ = 0;
  std::vector<Piece> pieces_;
  std::mutex lock_;
  std::chrono::steady_clock::time_point flushed_{};
};

}  // namespace mmverify::proofs
