#include "proofs/dag/scenes.hpp"

#include "proofs/engine/random.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::dag {
namespace {

using spec::micromap::micro_triangles;

Map packed(Level n, Format f, const States& states) { return {n, spec::micromap::pack(states, f)}; }

/// The map whose states' bits are those of a number.  Domain: 4^n b <= 64.
Map of_bits(Level n, Format f, std::uint64_t x) {
  States states;
  for (std::uint64_t k = 0; k < micro_triangles(n); ++k) {
    states.push_back(static_cast<State>(x & ((1u << bits(f)) - 1)));
    x >>= bits(f);
  }
  return packed(n, f, states);
}

/// Kinds 0 to 3: tiles that are not of one state, 0 and 1 alike but for their last state.  Then one state each.
constexpr unsigned mixed_tiles = 4;
States tile(Format f, unsigned kind) {
  const State other = f == Format::two_state ? State::O : State::UT;
  if (kind < mixed_tiles) {
    States states(64, State::T);
    states[5 + 11 * (kind / 2)] = other;
    if (kind % 2 == 1) states[63] = State::O;
    return states;
  }
  constexpr State all[] = {State::T, State::O, State::UO};
  return States(64, all[kind - mixed_tiles]);
}

/// Four tiles, by the digits of k to the base `kinds`: 0 stands for T.
Map four_tiles(Format f, std::uint64_t k, unsigned kinds) {
  States states;
  for (unsigned c = 0; c < 4; ++c, k /= kinds) {
    const auto digit = static_cast<unsigned>(k % kinds);
    const States next = tile(f, digit == 0 ? mixed_tiles : digit - 1);
    states.insert(states.end(), next.begin(), next.end());
  }
  return packed(4, f, states);
}

/// Subtree `number` of level m: mixed, and unlike every other number's.  Domain: number < 16.
States mixed_subtree(Level m, Format f, unsigned number) {
  States states(micro_triangles(m), State::T);
  const State mark = f == Format::two_state || number % 2 == 0 ? State::O : State::UT;
  const std::uint64_t unit = states.size() / 16;
  states[number * unit] = states[states.size() - 1 - (15 - number) * unit] = mark;
  return states;
}

constexpr Format formats[] = {Format::two_state, Format::four_state};

}  // namespace

std::uint64_t small_scenes(Level n) {
  constexpr std::uint64_t all[] = {4 + 16, 256 + 65536, 65536, 16 + 25, 2 * (81 * 81 + 625)};
  return all[n];
}

std::string about_small_scenes(Level n) {
  constexpr const char* all[] = {
      "all ordered pairs of maps of level 0, both formats",
      "all ordered pairs of maps of level 1, both formats", "all 2-state maps of level 2",
      "all ordered pairs of 4 and of 5 maps of level 3, both formats",
      "all ordered pairs of 81 maps and 625 single ones of four tiles, level 4, both formats"};
  return all[n];
}

Scene small_scene(Level n, std::uint64_t k) {
  if (n == 2) return {Format::two_state, {of_bits(2, Format::two_state, k)}};
  if (n == 4) {
    const Format f = formats[k % 2];
    k /= 2;
    if (k < 6561) return {f, {four_tiles(f, k % 81, 3), four_tiles(f, k / 81, 3)}};
    return {f, {four_tiles(f, k - 6561, 5)}};
  }
  if (n == 3) {
    const Format f = formats[k >= 16 ? 1 : 0];
    const std::uint64_t each = k >= 16 ? 5 : 4;
    k = k >= 16 ? k - 16 : k;
    return {f,
            {packed(3, f, tile(f, 2 + static_cast<unsigned>(k % each))),
             packed(3, f, tile(f, 2 + static_cast<unsigned>(k / each)))}};
  }
  const std::uint64_t two_state = std::uint64_t{1} << 2 * micro_triangles(n);
  const Format f = formats[k >= two_state ? 1 : 0];
  k = k >= two_state ? k - two_state : k;
  const std::uint64_t width = bits(f) * micro_triangles(n);
  return {f, {of_bits(n, f, k & ((std::uint64_t{1} << width) - 1)), of_bits(n, f, k >> width)}};
}

Scene mask_scene(Level n, std::uint64_t k) {
  const Format f = formats[k % 2];
  const Level below = spec::dag::child_level(n);
  States states;
  for (unsigned c = 0; c < spec::dag::children(n); ++c) {
    const bool mixed = (k / 2 >> c & 1) != 0;
    const auto state = static_cast<State>((c * 5 + 3) / 4 % (1u << bits(f)));
    const States next = mixed ? mixed_subtree(below, f, c) : States(micro_triangles(below), state);
    states.insert(states.end(), next.begin(), next.end());
  }
  return {f, {packed(n, f, states)}};
}

Scene sample_scene(Level n, std::uint64_t seed, std::uint64_t k) {
  Random random(seed, n, k);
  Scene scene{formats[k % 2], {}};
  const Format f = scene.format;
  const unsigned b = bits(f);
  const std::uint64_t count = n <= 9 ? 1 + random.below(5) : 1 + random.below(2);
  const auto any_state = [&] { return static_cast<State>(random.below(1u << b)); };
  for (std::uint64_t m = 1; m <= count; ++m) {
    const Level level = m == count ? n
                        : n <= 6   ? static_cast<Level>(random.below(n + 1))
                                   : n - static_cast<Level>(random.below(3));
    const std::uint64_t all = micro_triangles(level);
    std::uint64_t kind = random.below(6);
    if (kind >= 4 && (scene.maps.empty() || scene.maps.back().level != level)) kind -= 3;
    States states(all, any_state());
    if (kind == 0) {  // noise in a part of it, or all
      const std::uint64_t share = std::uint64_t{1} << 2 * random.below(std::min<Level>(level, 3) + 1);
      for (std::uint64_t at = all - all / share; at < all; ++at) states[at] = any_state();
    } else if (kind == 1) {  // few among many
      const std::uint64_t few = 1 + random.below(std::min<std::uint64_t>(all, 64));
      for (std::uint64_t j = 0; j < few; ++j) states[random.below(all)] = any_state();
    } else if (kind == 2) {  // subtrees of a level, each one of three
      const std::uint64_t run =
          micro_triangles(std::min<Level>(level, 2 + static_cast<Level>(random.below(4))));
      std::vector<States> three(3, States(run, any_state()));
      for (States& one : three)
        for (std::uint64_t j = random.below(3); j < run; j += 1 + random.below(run)) one[j] = any_state();
      for (std::uint64_t at = 0; at < all; at += run) {
        const States& one = three[random.below(3)];
        std::copy(one.begin(), one.end(), states.begin() + static_cast<std::ptrdiff_t>(at));
      }
    } else if (kind == 3) {  // an outline: a state up to some place and another from there on, many times
      for (std::uint64_t at = 0; at < all;) {
        const std::uint64_t run = std::min(all - at, 1 + random.below(std::min<std::uint64_t>(all, 400)));
        const State s = any_state();
        for (std::uint64_t j = 0; j < run; ++j) states[at++] = s;
      }
    } else {
      states = states_of(scene.maps.back(), f);
      if (kind == 5) {
        State& one = states[random.below(all)];
        one = static_cast<State>(static_cast<unsigned>(one) ^ 1);
      }
    }
    scene.maps.push_back(packed(level, f, states));
  }
  return scene;
}

Scene many_maps(Level n, std::uint64_t seed, std::uint64_t k) {
  Random random(seed, 701 + n, k);
  Scene scene{formats[k % 2], {}};
  const std::uint64_t count = n == 0 && k < 2 ? 65'537 + random.below(100) : 257 + random.below(300);
  for (std::uint64_t m = 0; m < count; ++m) {
    const auto level = static_cast<Level>(random.below(n + 1));
    States states;
    for (std::uint64_t left = micro_triangles(level); left > 0; --left)
      states.push_back(static_cast<State>(random.below(1u << bits(scene.format))));
    scene.maps.push_back(packed(level, scene.format, states));
  }
  return scene;
}

std::string text_of_number(std::uint64_t k) { return fmt::format("k={}", k); }
std::string text_of_sample(std::uint64_t seed, std::uint64_t k) {
  return fmt::format("sample:{}:{}", seed, k);
}

std::uint64_t number_from_text(const std::string& text, std::uint64_t limit) {
  const Groups parts = groups_of(text, "k=([0-9]{1,10})");
  if (!parts || std::stoull((*parts)[1]) >= limit)
    throw BadCase(fmt::format("'{:.60}': write k= and a number below {}", text, limit));
  return std::stoull((*parts)[1]);
}

std::pair<std::uint64_t, std::uint64_t> sample_from_text(const std::string& text) {
  const Groups parts = groups_of(text, "sample:([0-9]{1,19}):([0-9]{1,9})");
  if (!parts) throw BadCase(fmt::format("'{:.60}': write sample:SEED:K", text));
  return {std::stoull((*parts)[1]), std::stoull((*parts)[2])};
}

}  // namespace mmverify::proofs::dag
