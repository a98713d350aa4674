// The clocks and medians of benches.
#pragma once

#include <time.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace mmverify::bench {

/// The processor time of this thread in ns: it stands still while others run in its place.  Shared caches, a
/// shared core, or the machine below this one may still disturb it.
inline double thread_ns() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e9 + static_cast<double>(t.tv_nsec);
}

/// The middle number, of an even count the upper.  Domain: not empty.
inline double median(std::vector<double> x) {
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::nth_element(x.begin(), middle, x.end());
  return *middle;
}

/// The median of the rounds' times, the least and the most, in their unit.
struct Spread {
  double median = 0, least = 0, most = 0;
};

/// The spread of the rounds' times, each divided by `parts`.  Domain: not empty.
inline Spread spread_of(const std::vector<double>& times, double parts = 1) {
  const auto [least, most] = std::minmax_element(times.begin(), times.end());
  return {median(times) / parts, *least / parts, *most / parts};
}

/// The time of one round in ns.
template <class Work>
double once_ns(const Work& work) {
  const double start = thread_ns();
  work();
  return thread_ns() - start;
}

/// The spread of some rounds' times, in ns.  Domain: rounds > 0.
template <class Work>
Spread rounds_ns(std::size_t rounds, const Work& work) {
  std::vector<double> ns;
  for (std::size_t round = 0; round < rounds; ++round) ns.push_back(once_ns(work));
  return spread_of(ns);
}

/// The median of some rounds' times, in ns.  Domain: rounds > 0.
template <class Work>
double median_ns(std::size_t rounds, const Work& work) {
  return rounds_ns(rounds, work).median;
}

}  // namespace mmverify::bench
