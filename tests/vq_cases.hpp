// Maps for the tests of VQ encoders, and what an encoder did to one.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "impl/vq/vq.hpp"

namespace mmverify::tests {

namespace vq = impl::vq;

template <class Map>
constexpr std::uint32_t side_of = std::tuple_size_v<Map> == 256 ? 16 : 32;

/// A shape: O well inside, T well outside, else C; continuous where `band` allows.
template <class Map>
Map blob(std::mt19937& random, double band) {
  constexpr std::uint32_t side = side_of<Map>;
  std::uniform_real_distribution<double> within(0, side), radius(side / 8.0, side / 2.0);
  const double x = within(random), y = within(random), r = radius(random),
               stretch = 4 * radius(random) / side, wave = radius(random);
  Map map;
  for (std::uint32_t k = 0; k < map.size(); ++k) {
    const double dx = (k % side + 0.5 - x) / stretch, dy = k / side + 0.5 - y;
    const double d = std::hypot(dx, dy) - r + std::sin(wave * std::atan2(dy, dx));
    map[k] = d < -band ? vq::State::O : d > band ? vq::State::T : vq::State::C;
  }
  return map;
}

template <class Map>
Map noise(std::mt19937& random) {
  Map map;
  for (vq::State& s : map) s = static_cast<vq::State>(random() % 3);
  return map;
}

/// How many O and T became C; a test fails where anything else changed.
template <class Map>
std::uint32_t substitutions(const Map& from, const Map& to) {
  std::uint32_t count = 0;
  for (std::size_t k = 0; k < from.size(); ++k) {
    EXPECT_TRUE(to[k] == from[k] || to[k] == vq::State::C) << "conservative: " << k;
    count += to[k] != from[k] ? 1 : 0;
  }
  return count;
}

template <class Block>
Block random_block(std::mt19937& random) {
  Block block;
  for (auto& byte : block) byte = static_cast<std::uint8_t>(random());
  return block;
}

}  // namespace mmverify::tests
