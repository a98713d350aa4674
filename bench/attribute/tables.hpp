// Attribute micromaps, error and time, as tables and a picture.
#pragma once

#include "bench/attribute/bench.hpp"
#include "bench/result.hpp"

namespace mmverify::bench {

Result attribute_tables(const AttributeFigures& figures, const AttributeBenchOptions& options);

/// Times of lookups and errors of remaps by level; below, error against time of remaps at the highest level of maps, and
/// of bakes.
picture::Picture attribute_picture(const AttributeFigures& figures);

}  // namespace mmverify::bench
