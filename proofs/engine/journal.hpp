// A file that a run appends to as it works, so that it can be killed at any moment and resume later.
#pragma once

#include <chrono>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "proofs/engine/share.hpp"
#include "proofs/engine/tally.hpp"

namespace mmverify::proofs {

/// A journal that cannot be resumed: of another run, damaged, in use, or without disk space.  what() names the file.
struct BadJournal : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The identity of a run: items (name, value).  Two runs that agree on all of them do the same work.
using Identity = std::vector<std::pair<std::string, std::string>>;

/// The first item in which two identities differ, in words; empty if they are equal.
std::string difference(const Identity& theirs, const Identity& ours);

/// A file of lines, each a checksum and a JSON object.  The first names the run, and the others are finished pieces
/// of work.  The work of a damaged line is repeated.
class Journal {
 public:
  /// Opens or makes the file, and reads what is finished.  Throws BadJournal.
  Journal(std::string path, Identity identity);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// A finished piece: units [units.begin, units.end) of the `of` units of the work `about`.
  struct Piece {
    std::string about;
    Chunk units;
    std::uint64_t of = 0;
    Tally tally;
  };

  /// The pieces that the file had when it was opened, for one name and number of units, in order and disjoint.
  std::vector<Piece> finished(const std::string& about, std::uint64_t of) const;

  /// Appends a piece.  It survives the death of this process at once, and that of the machine after the next flush.
  /// An append flushes by itself if no append has done so for a quarter of a second.  Several threads may call at
  /// once. Throws BadJournal if the file cannot be written; it then ends with the last whole line.
  void append(const Piece& piece);

  /// Deletes all pieces: they do not describe the run any more.  Throws BadJournal.
  void discard();

  /// Writes all appended pieces through to the disk.
  void flush();

  /// The number of bytes that belonged to no whole line when the file was opened.
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
