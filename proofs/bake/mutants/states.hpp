// Deliberately wrong bakers: a state changed in one particular case, or the case mistaken for another.
#pragma once

#include <cmath>
#include <limits>

#include "proofs/bake/subject.hpp"
#include "proofs/bake/truth/truth.hpp"

namespace mmverify::proofs::bake {

using Mistake = std::function<void(Case&)>;

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
inline void first_mip_alone(Case& one) {
  one.mips = 1;
  one.alpha.resize(texels_of(one.width, one.height, 1));
}
inline void without_vertex_factor(Case& one) { one.vertex_factor = 1; }
inline void other_filter(Case& one) {
  one.filter = one.filter == Filter::nearest ? Filter::bilinear : Filter::nearest;
}
inline void without_last_mip(Case& one) {
  one.mips = std::max(1u, one.mips - 1);
  one.alpha.resize(texels_of(one.width, one.height, one.mips));
}
inline void byte_border(Case& one) {
  if (one.texel == Texel::unorm16) one.border &= 255;
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

inline void forgets_wide(const Case& one, Level n, std::vector<State>& states) {
  if (n != 8 || one.width <= 256) return;
  for (State& s : states) s = spec::micromap::as_unknown(s);
}

/// The texels under the box of a micro-triangle, as filters take them: two more than its length along each axis.
inline std::uint64_t texels_under(const Case& one, Level n) {
  const auto along = [&](std::size_t axis, std::uint32_t size) {
    const auto [low, high] = std::minmax({one.uv[axis], one.uv[2 + axis], one.uv[4 + axis]});
    return 2 + static_cast<std::uint64_t>(std::ldexp((double{high} - low) * size, -static_cast<int>(n)));
  };
  return along(0, one.width) * along(1, one.height);
}
/// An unknown whose texels, counted in 32 bits, are none, is opaque.
inline void counts_in_32_bits(const Case& one, Level n, std::vector<State>& states) {
  if (const std::uint64_t texels = texels_under(one, n);
      texels != 0 && texels % (std::uint64_t{1} << 32) == 0)
    for (State& s : states)
      if (spec::micromap::unknown(s)) s = State::O;
}
/// Clamps an axis along which a coordinate is 512 repeats away.
inline void clamps_far(Case& one) {
  const auto is_far = [&](std::size_t axis) {
    return std::max({std::fabs(one.uv[axis]), std::fabs(one.uv[2 + axis]), std::fabs(one.uv[4 + axis])}) >=
           512;
  };
  if (is_far(0)) one.wrap_u = Wrap::clamp_to_edge;
  if (is_far(1)) one.wrap_v = Wrap::clamp_to_edge;
}
inline void forgets_long(const Case& one, Level n, std::vector<State>& states) {
  if (texels_under(one, n) >> 30 != 0)
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
