// Asking a library about maps and codes.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "dock/library.hpp"

namespace mmverify::dock {

/// A reply that outlives its worker.
struct Answer {
  bool taken;
  std::vector<std::uint8_t> bytes;
};

/// Asks any worker.  Throws CaseBroken, its text `what it did at level N` and `doing`, for example
/// "encoding 2-state:0110".
Answer ask(const Library& library, const Question& question, const std::function<std::string()>& doing);

/// A question about the states of elements in one code.
struct Lookup {
  Call call;
  std::uint32_t level, format;
  std::span<const std::uint8_t> code;
  /// The elements' numbers, an array each of the entry point's.
  std::vector<const void*> arrays;
  std::function<std::string(std::uint64_t)> element;  ///< names one, for messages
};
/// State k of `out` is that of element k; asked in pieces of batch_size.  Throws CaseBroken, which names the
/// element that it is about, found by asking one by one.
void look_up(const Library& library, const Lookup& lookup, std::span<std::uint8_t> out);

/// A map as the laws' cases write it up to level 4, above its first bytes, size and checksum.
std::string map_text(std::uint32_t format, std::uint64_t states, std::span<const std::uint8_t> packed);
/// "the 2-state code 01 0b": up to 32 bytes, then size and checksum.  Of format 0 "block:010b", all of it, as
/// the laws' cases write it.
std::string code_text(std::uint32_t format, std::span<const std::uint8_t> code);

}  // namespace mmverify::dock
