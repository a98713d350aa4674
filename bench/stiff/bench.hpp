// Stiff inputs, on which rounded arithmetic errs or slows down: how often each method errs there, and its time beside
// that on ordinary inputs.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace mmverify::bench {

struct StiffBenchOptions {
  std::uint64_t samples =
      1'000'000;  ///< points a kind; at least 1. Bakers, weights and rationals take a part of it
  std::uint64_t seed = 1;
  std::size_t rounds = 7;                                 ///< of the timing; at least 1
  std::function<void(const std::string&)> progress = {};  ///< receives the name of each step that begins
};

/// The figures of one method on one kind of stiff inputs, and on as many ordinary ones.
struct StiffFigure {
  std::string kind = {}, method = {};
  std::uint64_t cases = 0;  ///< answers that were judged, of stiff inputs; as many of ordinary ones
  std::uint64_t wrong = 0;  ///< answers that are not the exact ones
  std::uint64_t ordinary_wrong = 0;
  double ns = 0;  ///< an answer on stiff inputs, median over the rounds
  /// ns of the fastest round and of the slowest; of methods that are timed once, nothing.
  std::optional<double> least_ns = {}, most_ns = {};
  double ratio = 0;  ///< median over the rounds of that / an ordinary answer's time in the same round
  std::optional<double> exact = {};  ///< of our bakers: the share of stiff answers that took whole numbers
  bool is_ours = false;              ///< a function of this library

  double share() const { return static_cast<double>(wrong) / static_cast<double>(cases); }
  double ordinary_share() const { return static_cast<double>(ordinary_wrong) / static_cast<double>(cases); }
};

/// Kinds of stiff points (index, level 8; all numbers are binary32):
///   lines                 u and v a few ulp beside grid lines
///   sums                  uf + vf or u + v a hair beside 1
///   subnormal points      one or both below 2^-126
/// Kinds of stiff triangles in textures of 8 bits (bake, level 3, bilinear, repeated):
///   slivers               10^6 times as long as wide
///   cutoffs               alpha equals the cutoff at texels, or on lines through corners
///   repeats               10^6 repeats of the texture away
///   subnormal UVs         all coordinates below 2^-126, most beside a point where alpha is the cutoff
/// Kinds of stiff texels in textures of binary32 (attribute, level 2):
///   magnitudes            2^100 beside 2^-100, of both signs
///   subnormal texels      below 2^-126
/// Kind of stiff micro-triangle (weights there, the point uniform):
///   tiny                  level 12, where the determinant of Cramer's rule is 4^-12; ordinary is level 2
/// An answer is judged by the specification on rationals: an index, a state, a value and the weights.  A weight is wrong
/// if it is more than 2^-24 off, the bound of attribute.weights_on_floats.
/// Throws std::invalid_argument without samples or rounds.
std::vector<StiffFigure> stiff_figures(const StiffBenchOptions& options = {});

}  // namespace mmverify::bench
