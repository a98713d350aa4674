// A piece of a domain.
#pragma once

#include <cstdint>

namespace mmverify::proofs {

/// A half-open range of a domain's units (cells, rows, indices, samples), or of chunks of them.
struct Chunk {
  std::uint64_t begin, end;
  friend bool operator==(const Chunk&, const Chunk&) = default;
};

}  // namespace mmverify::proofs
