// Words that the tables of rays have in common.
#pragma once

#include <string>
#include <vector>

#include "bench/result.hpp"
#include "display/render/tracer.hpp"

namespace mmverify::bench {

inline std::vector<std::string> all_methods() {
  std::vector<std::string> names;
  for (const render::Method method : render::methods) names.emplace_back(name_of(method));
  return names;
}

inline constexpr char without_levels[] =
    "of all maps; not there of a texture, of a bitmask, and of VQ2 and VQ4, whose sides are fixed";

/// Adds the number of rays of ambient occlusion to a result's settings, if there are any.
inline void add_ambient(Result& result, unsigned rays) {
  if (rays != 0)
    result.settings.push_back({whole("ambient_occlusion", setting, {1, render::most_ambient},
                                     "rays of ambient occlusion from each hit; not there without any")
                                   .if_any(),
                               std::uint64_t{rays}});
}

}  // namespace mmverify::bench
