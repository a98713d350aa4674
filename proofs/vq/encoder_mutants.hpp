// Deliberately wrong encoders, which change a code if its transforms are particular ones.
#pragma once

#include <set>

#include "proofs/vq/encoder_checks.hpp"

namespace mmverify::proofs::vq {

template <class Format>
using Spoil = std::function<void(const Map<Format>&, Encoded<Format>&)>;

template <class Format>
std::function<void(Functions&)> spoiled(Spoil<Format> spoil) {
  return [=](Functions& functions) {
    auto& encode = functions.codec<Format>().encode;
    encode = [=, real = encode](const Map<Format>& map) {
      Encoded<Format> encoded = real(map);
      spoil(map, encoded);
      return encoded;
    };
  };
}

/// The first vector of a quadrant whose index is not that of a uniform one; 64 if there is none.
template <class Format>
std::uint32_t looked_up_in(const Format& fields, std::size_t q) {
  std::uint32_t vector = 0;
  while (vector < 64 && (static_cast<std::size_t>(spec::vq::quadrant_of(vector % 8, vector / 8)) != q ||
                         fields.indices[vector] < 3))
    ++vector;
  return vector;
}

inline auto& code_of(Vq2& fields, std::size_t q, std::uint32_t index) {
  return index < 6 ? fields.shared[index - 3] : fields.own[q][index - 6];
}
inline auto& code_of(Vq4& fields, std::size_t, std::uint32_t index) { return fields.codebook[index - 3]; }

/// A mutant for one transform of one quadrant: an entry in use loses its lowest bit.  C becomes O or T or, in an
/// entry without C, O becomes T.
template <class Format>
std::function<void(Functions&)> loses_a_check(std::size_t q, std::uint32_t transform) {
  return spoiled<Format>([=](const Map<Format>&, Encoded<Format>& encoded) {
    Format fields = spec::vq::from_bytes<Format>(encoded.block);
    const std::uint32_t vector = looked_up_in(fields, q);
    if (fields.transforms[q].number() != transform || vector == 64) return;
    auto& code = code_of(fields, q, fields.indices[vector]);
    code = static_cast<std::remove_reference_t<decltype(code)>>(code & (code - 1));
    encoded.block = spec::vq::bytes(fields);
  });
}

/// A mutant for one transform of one quadrant: a vector becomes all C, and the substitutions are counted.
template <class Format>
std::function<void(Functions&)> gives_up_a_vector(std::size_t q, std::uint32_t transform) {
  return spoiled<Format>([=](const Map<Format>& map, Encoded<Format>& encoded) {
    Format fields = spec::vq::from_bytes<Format>(encoded.block);
    const std::uint32_t vector = looked_up_in(fields, q);
    if (fields.transforms[q].number() != transform || vector == 64) return;
    fields.indices[vector] = 1;
    encoded.block = spec::vq::bytes(fields);
    encoded.substitutions =
        static_cast<std::uint32_t>(substituted<Format>(map, meant<Format>(encoded.block)).answer);
  });
}

/// A mutant that uses neither entry if a block uses two in all: their vectors become all C, and are counted.
inline std::function<void(Functions&)> gives_up_two_entries() {
  return spoiled<Vq2>([](const Map<Vq2>& map, Encoded<Vq2>& encoded) {
    Vq2 fields = spec::vq::from_bytes<Vq2>(encoded.block);
    std::set<std::uint32_t> used;
    const auto entry = [&](std::uint32_t vector) {
      const auto q = static_cast<std::uint32_t>(spec::vq::quadrant_of(vector % 8, vector / 8));
      const std::uint32_t index = fields.indices[vector];
      return index < 6 ? index : 8 + 4 * q + index;
    };
    for (std::uint32_t vector = 0; vector < 64; ++vector)
      if (fields.indices[vector] >= 3) used.insert(entry(vector));
    if (used.size() != 2) return;
    for (auto& index : fields.indices)
      if (index >= 3) index = 1;
    encoded.block = spec::vq::bytes(fields);
    encoded.substitutions =
        static_cast<std::uint32_t>(substituted<Vq2>(map, meant<Vq2>(encoded.block)).answer);
  });
}

template <class Format>
std::function<void(Functions&)> counts_one_less(std::size_t q, std::uint32_t transform) {
  return spoiled<Format>([=](const Map<Format>&, Encoded<Format>& encoded) {
    const Format fields = spec::vq::from_bytes<Format>(encoded.block);
    if (fields.transforms[q].number() == transform && *encoded.substitutions > 0) --*encoded.substitutions;
  });
}

/// A mutant that encodes one map as another.
template <class Format>
std::function<void(Functions&)> instead(Map<Format> map, Map<Format> other) {
  return [=](Functions& functions) {
    auto& encode = functions.codec<Format>().encode;
    encode = [=, real = encode](const Map<Format>& given) { return real(given == map ? other : given); };
  };
}

}  // namespace mmverify::proofs::vq
