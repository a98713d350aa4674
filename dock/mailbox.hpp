// The mailbox in the memory that the tool and a worker process share.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "dock/entry_points.hpp"

namespace mmverify::dock {

enum class Outcome : std::uint32_t {
  starting,  ///< the library was not touched yet
  ready,
  cannot_open,  ///< dlopen failed
  cannot_load,
  not_here,
  answered,
  threw,
  changed_mode,
  wrote_before,
  unwritten,
  non_deterministic,
  too_large,
  no_resources  ///< the machine gave no thread or no memory to ask with
};

/// The library that was loaded.  The worker writes it, and so may whatever runs there: see description_fault().
struct Description {
  char name[128];
  char runs_on[4096];
  std::uint32_t max_level, flags;
  std::array<std::uint8_t, calls> has;   ///< by number of Call: 1 where it has the entry point
  mmverify_bake_support_t bake_support;  ///< zeros where it says nothing
  mmverify_attribute_support_t attribute_support;
};

/// The result of a command.
struct Report {
  Outcome outcome;
  std::uint64_t element;  ///< the one that `outcome` is about
  char message[512];
  std::uint32_t taken;         ///< what an encoder or decoder made of the map or code: 0 for nothing
  std::uint64_t answer_bytes;  ///< and how many bytes of it
};

struct Mailbox {
  std::atomic<std::uint32_t> turn;  ///< 0: the tool's, 1: the worker's; the futex both wait on
  // From the tool.
  Call call;
  std::uint32_t level;
  std::uint32_t one_by_one;        ///< call with one element at a time, to find the one that does it
  std::uint32_t this_level_alone;  ///< do not ask about other levels between
  std::uint64_t count;
  /// Of a map its states' bits, of micromap_through its mode, of attribute maps an order, two_formats(), flags of edges or a
  /// rounding; of others 0.
  std::uint32_t format;
  std::uint64_t blob_bytes;  ///< of the map or code that is asked about
  std::uint64_t room;        ///< of the answer to it: bytes that must be written, of an encoder that may be
  /// Questions on maps and codes to this entry point, at this level and of this format, that this worker was asked before;
  /// of one that came after others had died, the most that any of those was asked as well.
  std::uint32_t asked_before;
  // From the worker, the first also while it works.
  std::atomic<std::uint64_t> begun;          ///< elements before the batch that is being worked on
  std::atomic<std::uint64_t> calls;          ///< of the subject so far: what hangs is one call
  std::atomic<std::uint32_t> another_level;  ///< 1 while it asks about another level than the command's
  Report report;
  Description description;
};

}  // namespace mmverify::dock
