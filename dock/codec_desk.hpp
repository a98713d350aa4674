// A worker's calls about maps and codes: each is made at least twice, its answer in other bytes and other
// room.
#pragma once

#include <vector>

#include "dock/desk.hpp"

namespace mmverify::dock {

class CodecDesk {
 public:
  explicit CodecDesk(Desk& desk) : desk_(desk) {}

  /// Runs the command in the mailbox; throws Stop.
  void run();

 private:
  /// What one call said: the size of an encoder's code or, where `room` bytes were to be written, those; and
  /// 0 for a code that was refused.
  std::uint64_t call(std::byte* out, std::uint64_t room) const;
  /// The same with the output at its guard page, filled with `filling` before.
  std::uint64_t call_at_guard(std::uint64_t room, unsigned char filling);
  void encode(bool thorough);
  void answer(bool thorough);
  /// Two threads ask at once, several times.  Domain: the answer of `size` bytes is in its place.
  void ask_from_threads(std::uint64_t size);
  /// Compares the answer in its place with one that was asked for otherwise, over bytes of `filling`.
  void compare(const std::byte* before, const std::byte* after, std::uint64_t size, unsigned char filling,
               const char* how);
  std::byte* place(std::uint64_t size) const { return desk_.base + desk_.layout.blob_answer_at(size); }
  bool encodes() const { return desk_.mailbox.call == Call::tree_encode; }
  /// The first questions of a kind, and one in so many of the later ones.
  bool thorough();

  Desk& desk_;
  std::uint32_t asked_[calls][32][3] = {};
  std::vector<std::byte> before_;
};

}  // namespace mmverify::dock
