// Vertices of a base triangle.  Internal to impl/attribute.
#pragma once

#include "impl/attribute/bake/source.hpp"

namespace mmverify::impl::attribute::detail {

/// Domain: what check() of frame.hpp lets pass.
AttributeCounts bake_vertices(const Source& source, const BaseTriangle& uv, std::uint32_t level,
                              std::span<Rgba> out);

}  // namespace mmverify::impl::attribute::detail
