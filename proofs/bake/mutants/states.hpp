// Deliberately wrong bakers: a state changed in one particular case, or the case mistaken for another.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "proofs/bake/subject.hpp"
#include "proofs/bake/truth/truth.hpp"

namespace mmverify::proofs::bake {

using Mistake = std::function<void(Case&)>;

// ---------------------------------------------------------------------------------------------------------------------
// Mistakes
// ---------------------------------------------------------------------------------------------------------------------

inline void mirror_once_as_clamp(Case& one) {
  for (Wrap* const wrap : {&one.wrap_u, &one.wrap_v})
    if (*wrap == Wrap::mirror_once) *wrap = Wrap::clamp_to_edge;
}
/// Raises the cutoff by a hair.
inline void above_the_cutoff(Case& one) {
  one.cutoff = {one.cutoff.numerator * 10'000 + 1, one.cutoff.denominator * 10'000};
}
inline Mistake in_steps_of(int bits) {
  return [bits](Case& one) {
    for (float& x : one.uv) x = std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits);
  };
}
/// Shrinks the triangle to half its size, towards the first vertex.
inline void shrunk(Case& one) {
  for (std::size_t k = 2; k < 6; ++k) one.uv[k] = (one.uv[k] + one.uv[k % 2]) / 2;
}

/// Moves the triangle by a hair, so that a place on a line of texels falls to the texel before it.
inline void high_sides(Case& one) {
  for (float& x : one.uv) x -= 0x1p-18f;
}
inline Mistake masked_at(const Cutoff& cutoff) {
  return [=](Case& one) {
    one.blend = false;
    one.cutoff = cutoff;
  };
}
inline void quarter_margin_as_none(Case& one) {
  if (one.margin <= 0.25f) one.margin = 0;
}
inline void more_margin(Case& one) { one.margin += 0.0625f; }
inline void first_mip_alone(Case& one) {
  one.mips = 1;
  one.alpha.resize(texels_of(one.width, one.height, 1));
}
inline void without_vertex_factor(Case& one) { one.vertex_factor = 1; }
inline void other_filter(Case& one) {
  one.filter = one.filter == Filter::nearest ? Filter::bilinear : Filter::nearest;
}
inline void blended_above_half(Case& one) {
  if (one.blend) masked_at({2, 3})(one);
}

inline void two_mips(Case& one) {
  one.mips = std::min(one.mips, 2u);
  one.alpha.resize(texels_of(one.width, one.height, one.mips));
}
inline void without_last_mip(Case& one) {
  one.mips = std::max(1u, one.mips - 1);
  one.alpha.resize(texels_of(one.width, one.height, one.mips));
}
inline void without_first_mip(Case& one) {
  if (one.mips == 1) return;
  one.alpha.erase(one.alpha.begin(), one.alpha.begin() + std::ptrdiff_t{one.width} * one.height);
  one.width = std::max(1u, one.width / 2);
  one.height = std::max(1u, one.height / 2);
  --one.mips;
}
inline void rounded_product(Case& one) {
  one.factor = std::min(one.factor * one.vertex_factor, std::numeric_limits<float>::max());
  one.vertex_factor = 1;
}
inline void rounded_cutoff(Case& one) {
  // The product of 2^31 and a binary32 number in [2^-8, 2) is whole.
  const float x = static_cast<float>(one.cutoff.numerator) / static_cast<float>(one.cutoff.denominator);
  if (x >= 0x1p-8f && x < 2) one.cutoff = {static_cast<std::uint32_t>(std::ldexp(double{x}, 31)), 1u << 31};
}
inline void narrow_columns(Case& one) {
  for (std::size_t k = 0; k < std::size_t{one.width} * one.height; ++k)
    one.alpha[k] = one.alpha[k - k % one.width % 65536 / 256 * 256];
}
inline void byte_border(Case& one) {
  if (one.texel == Texel::unorm16) one.border &= 255;
}

/// Moves a triangle as if a texel's number were reduced by a product with the reciprocal in binary32.  If the
/// reciprocal is too small, a multiple of the side keeps the side as its remainder, and the last texel is taken.
inline void remainder_by_reciprocal(Case& one) {
  for (const std::size_t axis : {0u, 1u}) {
    if ((axis == 0 ? one.wrap_u : one.wrap_v) != Wrap::repeat) continue;
    const std::uint32_t size = axis == 0 ? one.width : one.height;
    const auto side = static_cast<float>(size), reciprocal = 1.0f / side;
    const float texel = std::floor(one.uv[axis] * side);
    if (texel - side * std::floor(texel * reciprocal) != side) continue;
    for (std::size_t k = axis; k < 6; k += 2) one.uv[k] -= 1 / side;
  }
}
/// Narrows textures whose sides are one less than a power of two and above 1000.
inline void narrow_when_nearly_a_power(Case& one) {
  for (const std::size_t axis : {0u, 1u}) {
    const std::uint32_t size = axis == 0 ? one.width : one.height;
    if (size < 1000 || (size & (size + 1)) != 0) continue;
    for (std::size_t k = axis; k < 6; k += 2)
      one.uv[k] *= static_cast<float>(size + 1) / static_cast<float>(size);
  }
}
inline void mirrors_by_centres(Case& one) {
  if (one.wrap_u == Wrap::mirrored_repeat && one.width > 64)
    for (std::size_t k = 0; k < 6; k += 2) one.uv[k] -= std::floor(one.uv[k]) / static_cast<float>(one.width);
}

/// A mutant that bakes another case.
inline Mutant asked_for_another(const char* name, Levels levels, const Mistake& mistake) {
  return mutant(name, "bake", levels, [&](Functions& functions) {
    functions.bake = [mistake, real = functions.bake](Case one, Level n, Format format) {
      mistake(one);
      return real(one, n, format);
    };
  });
}

/// A mutant whose states `becomes` makes from the right ones and those of another case's map.
inline Mutant beside_another(const char* name, Levels levels, const Mistake& mistake,
                             State (*becomes)(State is, State other)) {
  return mutant(name, "bake", levels, [&](Functions& functions) {
    functions.bake = [=, real = functions.bake](const Case& one, Level n, Format format) {
      Case another = one;
      mistake(another);
      auto baked = real(one, n, format);
      const auto other = real(another, n, format);
      if (baked && other)
        std::transform(baked->states.begin(), baked->states.end(), other->states.begin(),
                       baked->states.begin(), becomes);
      return baked;
    };
  });
}
inline Mutant unknown_where_another_differs(const char* name, Levels levels, const Mistake& mistake) {
  return beside_another(name, levels, mistake, [](State is, State other) {
    return is == other ? is : spec::micromap::as_unknown(is);
  });
}
inline Mutant side_of_another(const char* name, Levels levels, const Mistake& mistake) {
  return beside_another(name, levels, mistake, [](State is, State other) {
    return spec::micromap::unknown(is) ? spec::micromap::as_unknown(other) : is;
  });
}

// ---------------------------------------------------------------------------------------------------------------------
// One state of one map
// ---------------------------------------------------------------------------------------------------------------------

/// Changes the last state that `meant` accepts.
template <class Meant, class Becomes>
void change_last(std::vector<State>& states, Meant meant, Becomes becomes) {
  const auto last = std::find_if(states.rbegin(), states.rend(), meant);
  if (last != states.rend()) *last = becomes(*last);
}

using Texels = std::vector<std::uint32_t>;

// A mutant that `claims` calls unknown states O or T; one that `forgets` calls O or T unknown.

inline Spoil claims_one(const Texels& texels, Wrap u, Wrap v, float first) {
  return [=](const Case& one, Level, std::vector<State>& states) {
    if (one.alpha == texels && one.wrap_u == u && one.wrap_v == v && one.uv[0] == first)
      change_last(states, spec::micromap::unknown, [](State s) { return spec::micromap::force2(s); });
  };
}
inline Spoil forgets_one(const Texels& texels, State kind) {
  return [=](const Case& one, Level, std::vector<State>& states) {
    if (one.alpha == texels && one.wrap_u == Wrap::clamp_to_edge && one.wrap_v == Wrap::mirrored_repeat &&
        one.uv[0] == 0.125f)
      change_last(
          states, [kind](State s) { return s == kind; }, spec::micromap::as_unknown);
  };
}
inline Spoil forgets_last(const Texels& texels, State kind) {
  return [=](const Case& one, Level, std::vector<State>& states) {
    if (one.alpha == texels && one.wrap_u == Wrap::clamp_to_edge)
      change_last(
          states, [kind](State s) { return s == kind; }, spec::micromap::as_unknown);
  };
}
inline Spoil leans_once(const Texels& texels) {
  return [=](const Case& one, Level, std::vector<State>& states) {
    if (one.alpha == texels && one.wrap_u == Wrap::repeat && one.wrap_v == Wrap::mirror_once &&
        one.uv[0] == 0)
      change_last(states, spec::micromap::unknown,
                  [](State s) { return s == State::UO ? State::UT : State::UO; });
  };
}

inline void claims_wide(const Case& one, Level, std::vector<State>& states) {
  if (one.width <= 32) return;
  for (State& s : states) s = spec::micromap::force2(s);
}
inline Spoil claims_from(Level first) {
  return [first](const Case&, Level n, std::vector<State>& states) {
    if (n < first) return;
    for (State& s : states) s = spec::micromap::force2(s);
  };
}
inline void claims_three_mips(const Case& one, Level n, std::vector<State>& states) {
  if (one.mips < 3 || n < 6) return;
  for (State& s : states) s = spec::micromap::force2(s);
}
inline void forgets_three_mips(const Case& one, Level, std::vector<State>& states) {
  if (one.mips < 3) return;
  for (State& s : states) s = spec::micromap::as_unknown(s);
}
inline void forgets_wide(const Case& one, Level n, std::vector<State>& states) {
  if (n != 8 || one.width <= 256) return;
  for (State& s : states) s = spec::micromap::as_unknown(s);
}

/// Mutants on textures with `rows` rows, at a micro-triangle that samples are judged at.
inline Spoil claims_of_rows(std::uint32_t rows) {
  return [=](const Case& one, Level n, std::vector<State>& states) {
    if (one.height != rows) return;
    for (const std::uint32_t k : judged_at(one, n))
      if (spec::micromap::unknown(states[k])) {
        states[k] = spec::micromap::force2(states[k]);
        return;
      }
  };
}
inline Spoil forgets_of_rows(std::uint32_t rows) {
  return [=](const Case& one, Level n, std::vector<State>& states) {
    if (one.height != rows) return;
    for (const std::uint32_t k : judged_at(one, n))
      if (!spec::micromap::unknown(states[k])) {
        states[k] = spec::micromap::as_unknown(states[k]);
        return;
      }
  };
}

}  // namespace mmverify::proofs::bake
