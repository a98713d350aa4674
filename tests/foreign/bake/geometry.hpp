// Points and convex hulls in whole numbers.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tests/foreign/bake/numbers.hpp"

namespace mmverify::tests::foreign::bake {

template <class T>
struct Point {
  T x, y;
  bool operator==(const Point&) const = default;
};

template <class T>
T cross(const Point<T>& o, const Point<T>& a, const Point<T>& b) {
  return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// The convex hull, counter-clockwise, without points on its sides; of a line its ends, of a point it.
template <class T>
std::vector<Point<T>> hull(std::vector<Point<T>> all) {
  std::sort(all.begin(), all.end(),
            [](const Point<T>& a, const Point<T>& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  if (all.size() < 3) return all;
  std::vector<Point<T>> out;
  for (int half = 0; half < 2; ++half) {
    const std::size_t base = out.size();
    for (const Point<T>& p : all) {
      while (out.size() >= base + 2 && sign(cross(out[out.size() - 2], out.back(), p)) <= 0) out.pop_back();
      out.push_back(p);
    }
    out.pop_back();
    std::reverse(all.begin(), all.end());
  }
  return out;
}

}  // namespace mmverify::tests::foreign::bake
