#include "verdict.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rays {
namespace {

const char* name_of(State state) {
  constexpr const char* names[] = {"T", "O", "UT", "UO"};
  return names[state];
}

std::string name_of(const Hit& hit) {
  if (const auto state = state_of(hit)) return name_of(*state);
  const auto word = [](std::uint32_t outcome) {
    return outcome == missed       ? "nothing"
           : outcome == met_opaque ? "a hit"
           : outcome == asked      ? "a candidate"
           : outcome == both       ? "a candidate and a hit"
                                   : "no answer";
  };
  return std::string("no state: ") + word(hit.plain) + ", forced to two states " + word(hit.forced);
}

/// The index that the maps' states spell; -1 where one of them has no state of the format.
std::int64_t spelt(const Job& job, const Hit* hits) {
  std::int64_t index = 0;
  const std::uint32_t states = states_of(job.format);
  for (std::uint32_t map = job.maps; map-- > 0;) {
    const auto state = state_of(hits[map]);
    if (!state || *state >= states) return -1;
    index = index * states + *state;
  }
  return index;
}

std::string place(const Job& job, const Point& point) {
  char text[256];
  std::snprintf(text, sizeof text, "level %u, %u-state, at u %.9g v %.9g (%a, %a): ", job.level,
                states_of(job.format), double{point.u}, double{point.v}, double{point.u}, double{point.v});
  return text;
}

std::string described(const Job& job, const Point& point, const Hit* hits, std::uint32_t triangle) {
  std::string found = place(job, point);
  const bool special = triangle >= job.maps;
  if (special) {
    found += "a triangle with special index " + std::to_string(-1 - static_cast<int>(triangle - job.maps));
  } else {
    const std::int64_t index = spelt(job, hits);
    found += "expected micro-triangle " + std::to_string(point.index);
    if (job.level != 0) found += "; got " + (index < 0 ? "none" : std::to_string(index));
  }
  found += "\n        " + (special ? "" : "map " + std::to_string(triangle) + ": ") + "expected " +
           name_of(expected(job, triangle, point.index)) + "; got " + name_of(hits[triangle]) + " (" +
           point.about + ")";
  return found;
}

}  // namespace

void Verdict::add(const Job& job, const std::vector<Point>& points, const std::vector<Hit>& hits) {
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Hit* of_point = &hits[k * job.triangles];
    points[k].tie ? add_tie(job, points[k], of_point) : add_inside(job, points[k], of_point);
  }
}

void Verdict::add_tie(const Job& job, const Point& point, const Hit* hits) {
  for (std::uint32_t triangle = 0; triangle < job.triangles; ++triangle) {
    const auto state = state_of(hits[triangle]);
    if (state == expected(job, triangle, point.index))
      ++counts_.tie_exact;
    else if (std::any_of(point.touched.begin(), point.touched.end(),
                         [&](std::uint32_t index) { return state == expected(job, triangle, index); }))
      ++counts_.tie_touched;
    else
      ++counts_.tie_other;
  }
}

void Verdict::add_inside(const Job& job, const Point& point, const Hit* hits) {
  // A point whose u and v are each off by less than this meets the same micro-triangle.
  const double safe = std::ldexp(double{point.gap}, -static_cast<int>(job.level) - 1);
  if (!(safe > error_)) {
    counts_.near += job.triangles;
    return;
  }
  for (std::uint32_t triangle = 0; triangle < job.triangles; ++triangle) {
    const Hit& hit = hits[triangle];
    ++counts_.judged;
    if (hit.plain == met_opaque) add_barycentrics(job, point, hit);
    if (state_of(hit) == expected(job, triangle, point.index)) continue;
    if (counts_.wrong++ == 0) first_ = described(job, point, hits, triangle);
  }
}

void Verdict::add_barycentrics(const Job& job, const Point& point, const Hit& hit) {
  // Comparisons with NaN are false, and a NaN stays.
  for (const double off :
       {std::fabs(double{hit.u} - double{point.u}), std::fabs(double{hit.v} - double{point.v})}) {
    if (std::isfinite(farthest_) && !(off <= farthest_)) farthest_ = off;
    if (off <= error_ || !first_off_.empty()) continue;
    char text[64];
    std::snprintf(text, sizeof text, "the device says u %.9g v %.9g", double{hit.u}, double{hit.v});
    first_off_ = place(job, point) + text;
  }
}

}  // namespace rays
