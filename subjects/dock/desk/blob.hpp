// A question on a map, a code or a case, with the subject's answer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "subjects/dock/desk/caller.hpp"
#include "subjects/dock/desk/worker_memory.hpp"

namespace mmverify::dock {

class Blob {
 public:
  Blob(const Caller& caller, WorkerMemory& kept);

  const Signature& signature() const { return caller.entry().signature; }
  /// Earlier questions to the entry point at this level and in this format.
  std::uint32_t before() const { return caller.mailbox().asked_before; }
  std::uint64_t blob_bytes() const { return caller.mailbox().blob_bytes; }
  std::uint64_t room() const { return caller.mailbox().room; }
  /// The blob in the tool's memory.
  const std::uint8_t* original() const;
  /// Whether the question is repeated in every way: the first ones of a kind, and some of the later ones.
  bool is_thorough() const;
  /// The largest map or code, in bytes, that is asked in every way. A larger one (level 12, 4-state at level 11)
  /// takes so long that the further calls would count as a hang.
  static constexpr std::uint64_t most_thorough = std::uint64_t{3} << 18;
  bool is_large() const;

  /// The arguments with the blob at `bytes`, and `room` for the answer.
  Arguments arguments(const std::uint8_t* bytes, std::uint64_t room) const;
  Question question() const {
    return {arguments(bytes, answer.size()), answer.data(), answer.size(), size, 0};
  }
  QuestionCopy copy() const;

  /// Calls with the output at its guard page, filled with `filling`.
  std::uint64_t call_at_guard(std::uint64_t room, unsigned char filling, const std::uint8_t* bytes) const;
  /// Asks for the code again, with `room` for it. Its size may not change.
  void encode_within(std::uint64_t room, unsigned char filling, const std::uint8_t* bytes) const;
  /// Repeats the question with its answer in `out`.
  void ask_into(Fenced& out, const std::uint8_t* bytes, const std::string& how) const;
  /// Repeats the question right after the call `before`, whose answer has room in `out`.
  void ask_after(const Arguments& before, Fenced& out, const std::string& how) const;

  const Caller& caller;
  WorkerMemory& kept;
  const std::uint8_t *bytes, *elsewhere;  ///< the places of the blob for the first call and the second one
  std::vector<std::byte> answer;          ///< of the first call
  std::uint64_t size = 0;                 ///< the result of that call

 private:
  /// A copy of the map or code at another place. It is bytes and may lie anywhere, as texels of attributes
  /// may. A case of topic bake is not copied: its texels are numbers.
  const std::uint8_t* copied_elsewhere();
};

}  // namespace mmverify::dock
