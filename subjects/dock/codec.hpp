// Questions about maps and codes to a library.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "subjects/dock/library.hpp"

namespace mmverify::dock {

/// A reply whose bytes are its own: it outlives the worker.
struct Answer {
  bool taken;
  std::vector<std::uint8_t> bytes;
};

/// Asks a worker of the library. Throws CaseBroken with the text "WHAT IT DID at level N DOING", where
/// `doing` returns, for example, "encoding 2-state:0110".
Answer ask(const Library& library, const Question& question, const std::function<std::string()>& doing);

/// A question about the states of several elements in one code.
struct Lookup {
  Call call;
  std::uint32_t level, format;
  std::span<const std::uint8_t> code;
  /// The elements' numbers, one array for each of the entry point's.
  std::vector<const void*> arrays;
  std::function<std::string(std::uint64_t)> element;  ///< names an element, for messages
};
/// Writes the state of element k to out[k], in batches of batch_size. Throws CaseBroken, which names the
/// element at fault, found by asking one by one.
void look_up(const Library& library, const Lookup& lookup, std::span<std::uint8_t> out);

/// A map as in the laws' cases up to level 4; above, its first bytes, size and checksum.
std::string map_text(std::uint32_t format, std::uint64_t states, std::span<const std::uint8_t> packed);
/// A code for messages, "the 2-state code 01 0b": up to 32 bytes, then size and checksum. A code of format 0
/// is written whole, "block:010b", as in the laws' cases.
std::string code_text(std::uint32_t format, std::span<const std::uint8_t> code);

}  // namespace mmverify::dock
