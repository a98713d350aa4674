// A subject with one thing broken on purpose: what a law's mutants are made of.
#pragma once

#include <functional>

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

using SubjectOfIndex = std::shared_ptr<const IndexSubject>;

/// What an Altered subject changes; an empty function leaves the entry point alone.
struct Alteration {
  /// (level, point, true answer) -> answer, for `index` and `row_index`.
  std::function<std::uint32_t(Level, const GridPoint&, std::uint32_t)> on_point;
  /// The same for pairs of binary32 numbers.
  std::function<std::uint32_t(Level, float, float, std::uint32_t)> on_floats;
  /// (level, index, true corners) -> corners, for `corners` and `row_corners`.
  std::function<Corners(Level, std::uint32_t, Corners)> on_corners;
  /// Whether on_point reaches the answers on rationals too; not where a law takes them as its oracle.
  bool on_rationals = true;
  /// The same for pairs of binary64 numbers, and `index` alone.
  std::function<std::uint32_t(Level, double, double, std::uint32_t)> on_doubles = {};
};

/// `base` but for the alteration.
std::shared_ptr<const IndexSubject> altered(std::string name, SubjectOfIndex base, Alteration alteration);

/// `base` but for the alteration, and that only in batches that are rows.
std::shared_ptr<const IndexSubject> altered_in_rows(std::string name, SubjectOfIndex base,
                                                    Alteration alteration);

/// At one point of one level only, the answer becomes answer XOR flip.
Alteration only_at_point(Level level, std::int64_t ku, std::int64_t kv, Level grid, std::uint32_t flip);

/// At one index of one level only, two corners change places.
Alteration only_at_index(Level level, std::uint32_t index);

}  // namespace mmverify::proofs::index
