// One input for both validators, and one list of their findings.
#pragma once

#include <vector>

#include "impl/micromap/validate.hpp"
#include "spec/micromap/validate.hpp"

namespace mmverify::fuzz::micromap {

namespace fast = mmverify::impl::micromap;
namespace slow = mmverify::spec::micromap;

inline std::vector<fast::UsageCount> to_fast(std::span<const slow::UsageCount> counts) {
  std::vector<fast::UsageCount> out;
  for (const slow::UsageCount& c : counts) out.push_back({c.count, c.level, c.format});
  return out;
}

/// impl's violations in the specification's words.
inline std::vector<slow::Violation> to_slow(const std::vector<fast::Violation>& found) {
  std::vector<slow::Violation> out;
  for (const fast::Violation& v : found)
    out.push_back(
        {static_cast<slow::Rule>(v.rule), static_cast<slow::Place>(v.place), v.where, v.found, v.other});
  return out;
}

/// The answer of `judge` on impl's form of an input.
template <class Judge>
auto with_fast(const slow::Input& in, const Judge& judge) {
  fast::Input to;
  to.sets = in.sets;
  to.limits = {in.limits.two_state_level, in.limits.four_state_level, in.limits.lossy_four_state_level,
               in.limits.triangles};
  to.lossy = in.lossy;
  to.records = in.records;
  to.record_count = in.record_count;
  to.record_stride = in.record_stride;
  to.records_address = in.records_address;
  to.data = in.data;
  to.data_address = in.data_address;
  std::vector<fast::UsageCount> array_counts, geometry_counts;
  if (in.array_counts) to.array_counts = array_counts = to_fast(*in.array_counts);
  to.triangles = in.triangles;
  to.indexed = in.indexed;
  to.indices = in.indices;
  to.encoding = static_cast<fast::Encoding>(in.encoding);
  to.index_stride = in.index_stride;
  to.indices_address = in.indices_address;
  to.base_triangle = in.base_triangle;
  if (in.geometry_counts) to.geometry_counts = geometry_counts = to_fast(*in.geometry_counts);
  return judge(to);
}

inline std::vector<fast::Violation> validate_fast(const slow::Input& in) {
  return with_fast(in, fast::validate);
}

}  // namespace mmverify::fuzz::micromap
