// The shared parts of the harnesses of topic vq: the specification in impl's types, and the judgement of an
// encoding.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "impl/vq/vq.hpp"
#include "spec/vq/block.hpp"

namespace mmverify::fuzz {

namespace fast = mmverify::impl::vq;
namespace slow = mmverify::spec::vq;

template <class Format>
using States = std::array<fast::State, std::tuple_size_v<slow::Map<Format>>>;

/// The map that a block encodes, by the specification.
template <class Format>
States<Format> meant(const slow::BlockBytes<Format>& block) {
  return std::bit_cast<States<Format>>(slow::decode(slow::from_bytes<Format>(block)));
}

/// Aborts with who failed a requirement, the requirement, the format and the region.
inline void require(bool holds, const char* who, const char* what, std::size_t side, std::size_t region = 0) {
  if (holds) return;
  std::fprintf(stderr, "vq%zu: %s %s, region %zu,%zu\n", side, who, what, region % (8 * side),
               region / (8 * side));
  std::abort();
}

template <class Format>
void require_same(const States<Format>& expected, const States<Format>& got, const char* who,
                  const char* what) {
  for (std::size_t k = 0; k < got.size(); ++k) require(got[k] == expected[k], who, what, Format::side, k);
}

/// The number of substitutions.  Aborts unless T and O stay or become C, and C stays.
template <class Format>
std::uint32_t substitutions(const States<Format>& was, const States<Format>& is, const char* who) {
  std::uint32_t count = 0;
  for (std::size_t k = 0; k < was.size(); ++k) {
    require(is[k] == was[k] || is[k] == fast::State::C, who, "is not conservative", Format::side, k);
    count += is[k] != was[k] ? 1 : 0;
  }
  return count;
}

}  // namespace mmverify::fuzz
