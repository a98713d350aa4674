// The comparison that decides verdicts: plain loops, beside the sweep whose answers it compares.
#pragma once

#include <span>

#include "proofs/engine/tally.hpp"

namespace mmverify::proofs::index {

/// Whether two lists of answers are the same, and the digest of the second.
struct Agreement {
  bool all = true;
  std::uint64_t digest = 0;
};

/// The cases are numbered from `first` on.  Domain: as many wanted as got.
template <class Word>
Agreement agreement_of(std::uint64_t first, std::span<const Word> want, std::span<const Word> got) {
  Agreement agreement;
  Word different = 0;
  for (std::size_t t = 0; t < got.size(); ++t) {
    agreement.digest += Tally::digest_of(first + t, got[t]);
    different |= want[t] ^ got[t];
  }
  agreement.all = different == 0;
  return agreement;
}

}  // namespace mmverify::proofs::index
