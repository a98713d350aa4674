// Times of several ways to do one thing, measured in turns.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "bench/timing.hpp"

namespace mmverify::bench {

struct Work {
  std::size_t elements;
  std::function<void()> pass;
};

/// ns an element of each work, a number a round.
using RoundTimes = std::vector<std::vector<double>>;

/// Each round does each work once, for a third of a millisecond or more, so that a ratio compares neighbours
/// in time.
inline RoundTimes times_in_rounds(const std::vector<Work>& works, std::size_t rounds) {
  constexpr double long_enough_ns = 3e5;
  std::vector<std::size_t> passes;
  for (const Work& work : works) {
    work.pass();  // warms the caches
    const double ns = std::max(1.0, once_ns(work.pass));
    passes.push_back(static_cast<std::size_t>(std::clamp(long_enough_ns / ns, 1.0, 1e5)));
  }
  RoundTimes times(works.size());
  for (std::size_t round = 0; round < rounds; ++round)
    for (std::size_t w = 0; w < works.size(); ++w) {
      const double ns = once_ns([&] {
        for (std::size_t k = 0; k < passes[w]; ++k) works[w].pass();
      });
      times[w].push_back(ns / static_cast<double>(passes[w] * works[w].elements));
    }
  return times;
}

/// The median of a / b, round by round.
inline double median_ratio(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < a.size(); ++k) ratios.push_back(a[k] / b[k]);
  return median(std::move(ratios));
}

}  // namespace mmverify::bench
