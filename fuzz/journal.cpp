// The journal of a run that was killed, or a damaged journal: the pieces that it still holds were written.
//
// Input: 'r', then a file as it is; or else
//   a byte    how many pieces are appended, modulo 16; each has 4 bytes: about, begin, end, count
//   then, 3 bytes each, damage: two bytes of place, and a byte that is put there; 0xff: the file ends there
#include "proofs/engine/journal.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "proofs/engine/kinds.hpp"

namespace {

using namespace mmverify::proofs;

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "journal: %s\n", what);
  std::abort();
}

/// A file in memory, which a path names.
class MemoryFile {
 public:
  MemoryFile() : file_(memfd_create("journal", 0)) {
    if (file_ < 0) fail("no file in memory");
  }
  ~MemoryFile() { close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }
  std::string content() const {
    std::string text(static_cast<std::size_t>(lseek(file_, 0, SEEK_END)), '\0');
    if (pread(file_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
      fail("cannot be read");
    return text;
  }
  void replace(const std::string& text) const {
    if (ftruncate(file_, 0) != 0 ||
        pwrite(file_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
      fail("cannot be written");
  }

 private:
  int file_;
};

const Identity identity{{"laws", "index.equals_reference"}, {"seed", "1"}};
constexpr std::uint64_t units = 256;
const std::string names[] = {"index", "tree \xff", "", "line\nbreak"};

Journal::Piece piece_of(const std::uint8_t* bytes) {
  const std::uint64_t begin = bytes[1], end = bytes[2];
  Journal::Piece piece{names[bytes[0] % 4], {std::min(begin, end), std::max(begin, end) + 1}, units, Tally()};
  piece.tally.count(Kind::interior, bytes[3]);
  piece.tally.digest(begin, end);
  if (bytes[3] % 4 == 0)
    piece.tally.mismatch(Kind::interior, {}, [&] {
      Counterexample c;
      c.at = names[bytes[1] % 4];
      c.got = std::to_string(end);
      return c;
    });
  return piece;
}

bool is_same(const Journal::Piece& a, const Journal::Piece& b) {
  return a.units.begin == b.units.begin && a.units.end == b.units.end &&
         a.tally.digest() == b.tally.digest() && a.tally.cases() == b.tally.cases() &&
         a.tally.mismatches() == b.tally.mismatches() && a.tally.found().size() == b.tally.found().size();
}

/// The least begin of the appended pieces of a name; the number of units if there are none.
std::uint64_t first_unit(const std::vector<Journal::Piece>& appended, const std::string& name) {
  std::uint64_t first = units;
  for (const Journal::Piece& piece : appended)
    if (piece.about == name && piece.units.end <= units) first = std::min(first, piece.units.begin);
  return first;
}

/// Opens the journal again.  Finished pieces lie in order and apart, and were appended; `whole`: the first is among them.
void resume(const MemoryFile& file, const std::vector<Journal::Piece>* appended, bool whole) {
  const Journal journal(file.path(), identity);
  for (const std::string& name : names) {
    std::uint64_t end = 0;
    const std::vector<Journal::Piece> finished = journal.finished(name, units);
    if (whole && (finished.empty() ? units : finished.front().units.begin) != first_unit(*appended, name))
      fail("the first piece is not there, and nothing was damaged");
    for (const Journal::Piece& piece : finished) {
      if (piece.units.begin < end || piece.units.begin >= piece.units.end || piece.units.end > units)
        fail("finished pieces overlap, are empty or lie beyond the work");
      end = piece.units.end;
      if (appended != nullptr &&
          std::none_of(appended->begin(), appended->end(),
                       [&](const Journal::Piece& one) { return one.about == name && is_same(one, piece); }))
        fail("a finished piece that nobody appended");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const MemoryFile file;
  try {
    if (*data == 'r') {
      file.replace(std::string(data + 1, data + size));
      resume(file, nullptr, false);
      return 0;
    }
    const std::uint8_t *at = data + 1, *const end = data + size;
    std::vector<Journal::Piece> appended;
    {
      Journal journal(file.path(), identity);
      for (std::size_t count = *data % 16; count > 0 && end - at >= 4; --count, at += 4) {
        appended.push_back(piece_of(at));
        journal.append(appended.back());
      }
    }
    std::string text = file.content();
    for (; end - at >= 3; at += 3) {
      const std::size_t place = std::size_t{at[0]} | std::size_t{at[1]} << 8;
      if (text.empty()) break;
      if (at[2] == 0xff)
        text.resize(std::min(text.size(), place));
      else
        text[place % text.size()] = static_cast<char>(at[2]);
    }
    const bool whole = text == file.content();
    file.replace(text);
    resume(file, &appended, whole);
    resume(file, &appended, whole);  // the first one has cut a damaged end off
  } catch (const BadJournal& why) {
    if (*why.what() == '\0') fail("a refusal without a reason");
  }
  return 0;
}
