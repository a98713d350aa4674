// Baking: the range of alpha over a polygon, in boxes and strips.
#pragma once

#include <optional>

#include "spec/bake/strips.hpp"

namespace mmverify::spec::bake {

/// The range over any polygon, up to the first extremes that are enough: range_by_parts(), unless `enough` is true of
/// a lesser range on the way.
/// Domain, errors: those of for_each_part.
template <class Q, class Texel, class Enough>
Range<Q> range(const TextureOf<Texel>& t, const Polygon<Q>& polygon, Enough enough) {
  std::optional<Range<Q>> found;
  const auto take = [&found](const Range<Q>& here) {
    if (!found) found = here;
    found->take(here.least);
    found->take(here.greatest);
  };
  for_each_box<Q>(
      t, polygon,
      [&](const BoxTexels<Texel>& texels, const BoxPart<Q>& one, bool whole) {
        if (found && enough(*found)) return true;
        const Range<Q> bound = range<Q>(t, texels);
        const auto known = [&](const Range<Q>& some) {
          return found && found->least <= some.least && some.greatest <= found->greatest;
        };
        if (known(bound)) return true;
        if (whole || bound.least == bound.greatest) {
          take(bound);
          return true;
        }
        const std::int64_t columns = one.box.columns.size(), rows = one.box.rows.size();
        if (columns * rows < few_squares) return false;
        const Box few = texels_of(t, one.box);
        if (rows == 1 || few.rows.size() == 1) return settle_strip(t, one, true, take, known);
        if (columns == 1 || few.columns.size() == 1) return settle_strip(t, one, false, take, known);
        // A long part holds most texels, wherever it lies.
        const TexturePoint<Q> middle = centroid(one.part);
        for (const TexelAt<Texel>& at : {texels.least, texels.greatest})
          if (has_centre(t, one.part, middle, at)) take(Range<Q>(texel<Q>(t, at.i, at.j)));
        return known(bound);
      },
      [&](std::int64_t i, std::int64_t j, const Polygon<Q>& part) { take(range_in_square(t, i, j, part)); });
  return found.value();
}

/// The range over any polygon.
template <class Q, class Texel>
Range<Q> range(const TextureOf<Texel>& t, const Polygon<Q>& polygon) {
  return range(t, polygon, [](const Range<Q>&) { return false; });
}

template <class Q, class Texel>
State state(const TextureOf<Texel>& t, const Polygon<Q>& polygon, const Q& cutoff) {
  return state(range(t, polygon), cutoff);
}

}  // namespace mmverify::spec::bake
