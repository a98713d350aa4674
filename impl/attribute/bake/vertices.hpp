// Vertices of a base triangle.  Internal to impl/attribute.
#pragma once

#include "impl/attribute/bake/source.hpp"

namespace mmverify::impl::attribute::detail {

/// Domain: what check() of frame.hpp lets pass.
template <class Channel>
AttributeCounts bake_vertices(const Source<Channel>& source, const BaseTriangle& uv, std::uint32_t level,
                              std::span<RgbaOf<Channel>> out);

}  // namespace mmverify::impl::attribute::detail
