// Faces of a base triangle.  Internal to impl/attribute.
#pragma once

#include "impl/attribute/bake/source.hpp"

namespace mmverify::impl::attribute::detail {

/// Domain: what check() of frame.hpp lets pass.
/// Errors: std::invalid_argument for a triangle over too many texels.
template <class Channel>
AttributeCounts bake_faces(const Source<Channel>& source, const BaseTriangle& uv, std::uint32_t level,
                           std::span<RgbaOf<Channel>> out);

}  // namespace mmverify::impl::attribute::detail
