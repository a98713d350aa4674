// The part of a domain that a run judges: a shard of it, less the work that a journal has finished.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace mmverify::proofs {

class Journal;

/// A half-open range of a domain's units (cells, rows, indices, samples), or of chunks of them.
struct Chunk {
  std::uint64_t begin, end;
  friend bool operator==(const Chunk&, const Chunk&) = default;
};

/// Part `number` of `of`, counted from 1.
struct Shard {
  std::uint32_t number = 1, of = 1;
  bool whole() const { return of == 1; }
  friend bool operator==(const Shard&, const Shard&) = default;

  /// The shard's part of the chunks [0, chunks): [chunks (number-1) / of, chunks number / of).  The shards of one
  /// `of` tile them.
  Chunk chunks(std::uint64_t chunks) const {
    // chunks = q of + r, which avoids an overflow.
    const std::uint64_t q = chunks / of, r = chunks % of;
    const auto bound = [&](std::uint64_t k) { return q * k + r * k / of; };
    return {bound(number - 1), bound(number)};
  }
};

/// The units of a domain that one result covers.
struct Share {
  std::uint64_t from = 0, to = 0, of = 0;
  bool whole() const { return from == 0 && to == of; }
  friend bool operator==(const Share&, const Share&) = default;
};

/// The division of a law's domain, shared by the runner and `sweep` for one law, subject and level.
struct Division {
  std::optional<Shard> shard;
  Journal* journal = nullptr;  ///< null: no journal
  std::string about;           ///< the journal's name for this law, subject and level
  // Filled in by sweep.
  Share share;
  std::uint64_t resumed = 0;  ///< cases that the journal had
  bool finished = false;      ///< no chunk of the share is missing
};

}  // namespace mmverify::proofs
