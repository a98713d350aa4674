// Hits against the exact answers.
#pragma once

#include <string>

#include "shoot.hpp"

namespace rays {

struct Counts {
  std::uint64_t judged = 0,
                wrong = 0;  ///< points inside a micro-triangle, further from its edges than the error
  std::uint64_t near = 0;   ///< points inside, but nearer; not judged
  /// Points on an edge or a vertex of the grid, not judged: the state is the exact micro-triangle's, that of another one
  /// which the point touches, or neither.
  std::uint64_t tie_exact = 0, tie_touched = 0, tie_other = 0;
};

class Verdict {
 public:
  /// `error`: the most by which a device's u or v may differ from the ray's.
  explicit Verdict(double error) : error_(error) {}

  void add(const Job& job, const std::vector<Point>& points, const std::vector<Hit>& hits);

  const Counts& counts() const { return counts_; }
  /// The largest difference between a ray's u or v and that of its judged opaque hit; infinite or NaN where one is.
  double farthest() const { return farthest_; }
  /// Whether `farthest` is within the error, which judging states takes for granted.
  bool near_enough() const { return farthest_ <= error_; }
  /// A line about the first hit that is not near enough; empty where there is none.
  const std::string& first_off() const { return first_off_; }
  /// Two lines about the first wrong hit; empty where there is none.
  const std::string& first() const { return first_; }

 private:
  void add_tie(const Job& job, const Point& point, const Hit* hits);
  void add_inside(const Job& job, const Point& point, const Hit* hits);
  void add_barycentrics(const Job& job, const Point& point, const Hit& hit);

  double error_, farthest_ = 0;
  Counts counts_;
  std::string first_, first_off_;
};

}  // namespace rays
