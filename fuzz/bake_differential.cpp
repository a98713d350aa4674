// Any texture under any triangle: impl's map must be the specification's, micro-triangle by micro-triangle.
// The specification's states are those in whole numbers.  The definition, in rationals, has those for which whole
// numbers are too narrow, and a state in 1/16 of the inputs; bake_whole_test compares the two.
//
// Input; missing bytes are 0:
//   0  width - 1 (bits 0..2), height - 1 (bits 3..5), texels of 8 bits, 16, binary32 (bits 6..7: 0 1 2, 3 is
//      0)
//   1  the wraps' numbers u + 5 v, modulo 25
//   2  nearest (bit 0), BLEND (bit 1), two mips (bit 2), a second factor of 1/2 (bit 3), level (bits 4..5),
//      coordinates as binary32 by their bits (bit 6), a margin of 1/4 (bit 7)
//   3  the cutoff's numerator
//   4  its denominator - 1; 0 stands for 1/2
//   5  the first factor, in 64ths; 0 stands for 1
//   6  whole repeats that all coordinates are moved by, along u in the low four bits, a power of two
//   7  the border's texel, as the others
//   8  six coordinates, two bytes each, a signed number of 16384ths; or four bytes each
//   then texels, of 8 bits as they are, of 16 and binary32 a byte each that stands for byte 257, or for
//      (byte - 64) / 64
//
// With PLANTED the compared states are spoiled: with mirror-once along u, a border above 0 and a level above 1
// the last unknown is opaque.
//
// Covers: impl/bake/* impl/common/binary.hpp impl/common/few.hpp impl/common/wide.hpp
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "fuzz/share.hpp"
#include "impl/bake/triangles.hpp"
#include "spec/bake/state.hpp"
#include "spec/bake/whole/state.hpp"

namespace {

namespace fast = mmverify::impl::bake;
namespace slow = mmverify::spec::bake;
namespace whole = mmverify::spec::bake::whole;
using State = mmverify::spec::micromap::State;
using mmverify::fuzz::Share;
using mmverify::spec::Rational;
using mmverify::spec::Rational128;

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  std::uint32_t next() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  std::uint32_t next2() {
    const std::uint32_t low = next();
    return low | next() << 8;
  }
  std::uint32_t next4() {
    const std::uint32_t low = next2();
    return low | next2() << 16;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

struct Case {
  std::uint32_t width, height, mips, level;
  int wrap_u, wrap_v;
  bool nearest, blend;
  fast::Cutoff cutoff;
  std::array<float, 2> factors;
  float margin;
  std::uint32_t border;  ///< a byte, as texels are
  std::array<float, 6> uv;
};

/// A coordinate within (-2, 2), so that the specification's rows are few; 0 if it is not finite.
float bounded(float x) { return std::isfinite(x) ? std::fmod(x, 2.0f) : 0; }

Case read(Bytes& in, std::uint32_t sides) {
  Case c{};
  c.width = sides % 8 + 1;
  c.height = sides / 8 % 8 + 1;
  const std::uint32_t wraps = in.next(), how = in.next(), numerator = in.next(), denominator = in.next();
  c.wrap_u = static_cast<int>(wraps % 5);
  c.wrap_v = static_cast<int>(wraps / 5 % 5);
  c.nearest = (how & 1) != 0;
  c.blend = (how & 2) != 0;
  c.mips = (how & 4) != 0 ? 2 : 1;
  c.level = how >> 4 & 3;
  c.cutoff = denominator == 0 ? fast::Cutoff{1, 2} : fast::Cutoff{numerator, denominator + 1};
  const std::uint32_t factor = in.next(), away = in.next();
  c.factors = {factor == 0 ? 1 : static_cast<float>(factor) / 64, (how & 8) != 0 ? 0.5f : 1.0f};
  c.margin = (how & 128) != 0 ? 0.25f : 0;
  const auto moved = [](std::uint32_t power) {
    return power == 0 ? 0.0f : std::ldexp(1.0f, static_cast<int>(power));
  };
  const std::array<float, 2> by{moved(away & 15), moved(away >> 4)};
  c.border = in.next();
  for (std::size_t k = 0; k < 6; ++k)
    c.uv[k] = ((how & 64) != 0 ? bounded(std::bit_cast<float>(in.next4()))
                               : static_cast<float>(static_cast<std::int16_t>(in.next2())) / 16384) +
              by[k % 2];
  return c;
}

template <class Stored>
Stored texel(std::uint32_t byte) {
  if constexpr (std::is_same_v<Stored, float>)
    return (static_cast<float>(byte) - 64) / 64;
  else if constexpr (std::is_same_v<Stored, std::uint16_t>)
    return static_cast<std::uint16_t>(257 * byte);
  else
    return static_cast<std::uint8_t>(byte);
}
template <class Stored>
auto exact_texel(Stored stored) {
  if constexpr (std::is_same_v<Stored, float>)
    return slow::Binary32{std::bit_cast<std::uint32_t>(stored)};
  else
    return stored;
}

slow::Binary32 binary(float x) { return {std::bit_cast<std::uint32_t>(x)}; }

template <class Exact>
using Mips = std::vector<slow::TextureOf<Exact>>;

/// Calls ask(mode) with the alpha mode in numbers Q.
template <class Q, class Ask>
auto with_mode(const Case& c, Ask ask) {
  return c.blend ? ask(slow::Blend<Q>{})
                 : ask(slow::Mask<Q>{slow::fraction<Q>(c.cutoff.numerator, c.cutoff.denominator)});
}

template <class Q, class Exact>
State in_rationals(const Case& c, const Mips<Exact>& mips, std::uint32_t index) {
  const auto vertex = [&](std::size_t k) {
    return slow::place<Q>(binary(c.uv[2 * k]), binary(c.uv[2 * k + 1]));
  };
  const slow::BaseTriangle<Q> uv{vertex(0), vertex(1), vertex(2)};
  const Q margin = slow::number<Q>(binary(c.margin));
  const std::span<const slow::TextureOf<Exact>> all(mips);
  return with_mode<Q>(
      c, [&](const auto& mode) { return slow::micro_state(all, uv, c.level, index, mode, margin); });
}

/// The specification's state in rationals, of 128 bits if they suffice.
template <class Exact>
State in_rationals(const Case& c, const Mips<Exact>& mips, std::uint32_t index) {
  try {
    return in_rationals<Rational128>(c, mips, index);
  } catch (const std::overflow_error&) {
  } catch (const std::range_error&) {
  }
  return in_rationals<Rational>(c, mips, index);
}

/// The state in whole numbers; none where they are too narrow.
std::optional<State> in_whole_numbers(const Case& c, const std::vector<whole::WholeTexture>& mips,
                                      std::uint32_t index) {
  whole::Place place{{}, c.level, index, binary(c.margin)};
  for (std::size_t k = 0; k < 3; ++k) place.uv[k] = {binary(c.uv[2 * k]), binary(c.uv[2 * k + 1])};
  std::optional<slow::State> all;
  for (const whole::WholeTexture& t : mips) {
    const auto state = whole::state(t, place);
    if (!state) return std::nullopt;
    all = all ? slow::merged(*all, *state) : *state;
  }
  if (all == slow::State::O) return State::O;
  if (all == slow::State::T) return State::T;
  const auto leans = whole::leans(mips[0], place);
  if (!leans) return std::nullopt;
  return *leans ? State::UO : State::UT;
}

/// The specification's states, in whole numbers.  Where these are too narrow, and at one place of an input in 16, which
/// all its bytes choose, the state is that of the definition, in rationals.
template <class Exact>
class Specified {
 public:
  Specified(const Case& c, const Mips<Exact>& mips, const Share& share) : c_(c), mips_(mips) {
    if (share.of(16)) by_definition_ = share.below(1u << 2 * c.level);
    with_mode<Rational>(c, [&](const auto& mode) {
      for (const auto& t : mips) whole_.emplace_back(t, mode);
      return 0;
    });
  }
  std::uint8_t at(std::uint32_t index) const {
    std::optional<State> state;
    if (index != by_definition_) state = in_whole_numbers(c_, whole_, index);
    return static_cast<std::uint8_t>(state ? *state : in_rationals(c_, mips_, index));
  }
  std::optional<std::uint32_t> by_definition() const { return by_definition_; }

 private:
  const Case& c_;
  const Mips<Exact>& mips_;
  std::vector<whole::WholeTexture> whole_;
  std::optional<std::uint32_t> by_definition_;
};

void planted([[maybe_unused]] const Case& c, [[maybe_unused]] std::vector<std::uint8_t>& states) {
#ifdef PLANTED
  if (c.wrap_u != 4 || c.border == 0 || c.level < 2) return;
  const auto last = std::find_if(states.rbegin(), states.rend(), [](std::uint8_t s) { return s >= 2; });
  if (last != states.rend()) *last = 1;
#endif
}

template <class Stored>
void judge(const Case& c, Bytes in, const Share& share) {
  using Exact = decltype(exact_texel(Stored{}));
  std::vector<std::vector<Stored>> alpha(c.mips);
  std::vector<fast::Texels> mips;
  Mips<Exact> exact;
  const Stored border = texel<Stored>(c.border);
  for (std::uint32_t m = 0; m < c.mips; ++m) {
    const std::uint32_t width = std::max(1u, c.width >> m), height = std::max(1u, c.height >> m);
    slow::TextureOf<Exact> t{width, height};
    for (std::uint32_t k = 0; k < width * height; ++k) {
      alpha[m].push_back(texel<Stored>(in.next()));
      t.alpha.push_back(exact_texel(alpha[m].back()));
    }
    t.wrap_x = static_cast<slow::Wrap>(c.wrap_u);
    t.wrap_y = static_cast<slow::Wrap>(c.wrap_v);
    t.border = exact_texel(border);
    t.factor = {std::bit_cast<std::uint32_t>(c.factors[0])};
    t.vertex_factor = {std::bit_cast<std::uint32_t>(c.factors[1])};
    t.filter = c.nearest ? slow::Filter::nearest : slow::Filter::bilinear;
    exact.push_back(std::move(t));
    mips.push_back(fast::TexelView<Stored>{alpha[m].data(), width, height, width});
  }
  fast::AlphaMode mode = c.cutoff;
  if (c.blend) mode = fast::Blend{};
  const fast::TriangleBaker baker(mips, mode,
                                  {static_cast<fast::Wrap>(c.wrap_u), static_cast<fast::Wrap>(c.wrap_v),
                                   c.nearest ? fast::Filter::nearest : fast::Filter::bilinear,
                                   static_cast<float>(border), c.factors, c.margin});
  const std::uint32_t count = std::uint32_t{1} << 2 * c.level;
  std::vector<std::uint8_t> map((count + 3) / 4), states(count);
  baker.bake({{{c.uv[0], c.uv[1]}, {c.uv[2], c.uv[3]}, {c.uv[4], c.uv[5]}}}, c.level, map);
  for (std::uint32_t k = 0; k < count; ++k) states[k] = map[k / 4] >> 2 * (k % 4) & 3;
  planted(c, states);
  const Specified<Exact> specified(c, exact, share);
  const auto check = [&](std::uint32_t k) {
    const std::uint8_t state = specified.at(k);
    if (states[k] == state) return;
    std::fprintf(stderr, "bake: level %u, micro-triangle %u: %u, expected %u\n", c.level, k, states[k],
                 state);
    std::abort();
  };
  // Level 3 judges a fifth of the states, since the specification is slow.
  for (std::uint32_t k = 0; k < count; k += c.level < 3 ? 1 : 5) check(k);
  if (specified.by_definition()) check(*specified.by_definition());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes in(data, size);
  const std::uint32_t sides = in.next();
  const Case c = read(in, sides);
  const Share share(data, size);
  switch (sides >> 6) {
    case 1: judge<std::uint16_t>(c, in, share); break;
    case 2: judge<float>(c, in, share); break;
    default: judge<std::uint8_t>(c, in, share);
  }
  return 0;
}
