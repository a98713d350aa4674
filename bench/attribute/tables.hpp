// Attribute micromaps, error and time, as tables and a picture.
#pragma once

#include "bench/attribute/bench.hpp"
#include "bench/result.hpp"

namespace mmverify::bench {

Result attribute_tables(const AttributeFigures& figures, const AttributeBenchOptions& options);

/// A picture of lookups and remaps.  Above, the times of lookups by level; below, the errors of remaps by
/// level, and error against time of remaps at the highest level up to 12.
picture::Picture attribute_picture(const AttributeFigures& figures);

}  // namespace mmverify::bench
