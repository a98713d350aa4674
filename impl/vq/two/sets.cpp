#include "impl/vq/two/sets.hpp"

#include <cstring>

namespace mmverify::impl::vq::detail {
namespace {

constexpr std::uint64_t code_of(Entry e) { return (15 ^ set_of(e)) | (opaque(e) ? 16u : 0u); }

}  // namespace

Vectors2 vectors_of(const Map2& map) {
  Vectors2 vectors;
  for (std::uint32_t vector = 0; vector < 64; ++vector)
    for (std::uint32_t k = 0; k < 4; ++k) {
      const State s = map[2 * (vector % 8) + k % 2 + 16 * (2 * (vector / 8) + k / 2)];
      vectors[vector].t |= (s == State::T ? 1u : 0u) << k;
      vectors[vector].o |= (s == State::O ? 1u : 0u) << k;
    }
  return vectors;
}

Sets stored(std::uint32_t transform, const Sets& v) noexcept {
  Sets out;
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t to = moved<2>(transform, k);
    out.t |= (v.t >> to & 1) << k;
    out.o |= (v.o >> to & 1) << k;
  }
  return out;
}

Encoded2 written(const Vectors2& vectors, const Choice& choice) {
  Encoded2 out{};
  std::uint64_t word = 0;
  for (std::uint32_t q = 1; q < 4; ++q) word |= std::uint64_t{choice.transform[q]} << (3 * (q - 1));
  for (std::uint32_t k = 0; k < 3; ++k) word |= code_of(choice.shared[k]) << code_at(0, 3 + k);
  for (std::uint32_t q = 0; q < 4; ++q)
    for (std::uint32_t k = 0; k < 2; ++k) word |= code_of(choice.own[q][k]) << code_at(q, 6 + k);
  std::memcpy(out.block.data() + indices_bits / 8, &word, sizeof word);

  for (std::uint32_t vector = 0; vector < 64; ++vector) {
    const Sets& v = vectors[vector];
    const std::uint32_t q = quadrant_of_vector(vector);
    std::uint32_t index = static_cast<std::uint32_t>(State::C), most = 0;
    if (v.uniform()) {
      index = static_cast<std::uint32_t>(v.t == 15 ? State::T : v.o == 15 ? State::O : State::C);
      most = size(v.t) + size(v.o);
    } else {
      const Sets as_stored = stored(choice.transform[q], v);
      for (std::uint32_t k = 3; k < 8; ++k) {
        const std::uint32_t kept = keeps(k < 6 ? choice.shared[k - 3] : choice.own[q][k - 6], as_stored);
        if (kept <= most) continue;
        most = kept;
        index = k;
      }
    }
    out.substitutions += size(v.t) + size(v.o) - most;
    std::uint16_t two;
    std::memcpy(&two, out.block.data() + 3 * vector / 8, sizeof two);
    two = static_cast<std::uint16_t>(two | index << (3 * vector % 8));
    std::memcpy(out.block.data() + 3 * vector / 8, &two, sizeof two);
  }
  return out;
}

}  // namespace mmverify::impl::vq::detail
