// The mailbox in the memory that the tool shares with a worker process.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "subjects/dock/entry_points.hpp"

namespace mmverify::dock {

enum class Outcome : std::uint32_t {
  starting,  ///< no code of the library has run
  ready,
  cannot_open,  ///< dlopen failed
  cannot_load,
  not_here,
  answered,
  threw,
  changed_mode,
  unmasked_exceptions,
  left_registers,  ///< values in the x87 or MMX registers
  changed_signals,
  changed_struct,
  wrote_before,
  wrote_behind,
  unwritten,
  non_deterministic,
  too_large,
  no_resources  ///< the machine has no thread or memory for the question
};

/// The description of a library. The worker writes it, but so may the subject: see description_fault().
struct Description {
  char name[128];
  char runs_on[4096];
  std::uint32_t max_level, flags;
  std::array<std::uint8_t, calls> has;   ///< by number of Call: 1 if it has the entry point
  mmverify_bake_support_t bake_support;  ///< zeros if the subject has none
  mmverify_attribute_support_t attribute_support;
};

/// The result of a command.
struct Report {
  Outcome outcome;
  std::uint64_t element;  ///< the element at fault
  char message[512];
  std::uint32_t taken;         ///< 1 if the map or code was taken, 0 if refused
  std::uint64_t answer_bytes;  ///< bytes of the answer to it
};

struct Mailbox {
  std::atomic<std::uint32_t> turn;  ///< 0: the tool's, 1: the worker's; the futex both wait on
  // Written by the tool.
  Call call;
  std::uint32_t level;
  std::uint32_t one_by_one;        ///< call with one element at a time, to find the one at fault
  std::uint32_t this_level_alone;  ///< do not ask about other levels in between
  std::uint64_t count;
  /// For a map the bits of its states, for micromap_through its mode, for attribute maps an order,
  /// two_formats(), flags of edges or a rounding; for others 0.
  std::uint32_t format;
  std::uint64_t blob_bytes;  ///< size of the map or code in question
  std::uint64_t room;        ///< bytes of the answer that must be written; for an encoder, that may be
  /// Earlier questions on maps and codes to this entry point, at this level and in this format, to this
  /// worker. If it replaces workers that died, it starts from the highest count of any of them.
  std::uint32_t asked_before;
  // Written by the worker, `begun` and `calls` also while it works.
  std::atomic<std::uint64_t> begun;          ///< elements before the batch in work
  std::atomic<std::uint64_t> calls;          ///< of the subject so far: a hang is one call
  std::atomic<std::uint32_t> another_level;  ///< 1 during a question of another level, format or map
  Report report;
  Description description;
};

}  // namespace mmverify::dock
