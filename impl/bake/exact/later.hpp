// The exact states of a base triangle, made ready when one is first asked for: most triangles ask for none.  Internal
// to impl/bake.
#pragma once

#include <cstdint>
#include <optional>

#include "impl/bake/exact/base.hpp"

namespace mmverify::impl::bake::detail {

/// An ExactBase of these arguments, which outlive this.  One thread uses it.
class ExactLater {
 public:
  ExactLater(const TextureProperties& sides, const BaseTriangle& uv, std::uint32_t width,
             std::uint32_t height, index::Level level, Filter filter, const Dilation& dilation) noexcept
      : sides_(sides),
        uv_(uv),
        width_(width),
        height_(height),
        level_(level),
        filter_(filter),
        dilation_(dilation) {}

  const ExactBase& operator*() const {
    if (!made_) made_.emplace(sides_, uv_, width_, height_, level_, filter_, dilation_);
    return *made_;
  }

 private:
  const TextureProperties& sides_;
  const BaseTriangle& uv_;
  std::uint32_t width_, height_;
  index::Level level_;
  Filter filter_;
  const Dilation& dilation_;
  mutable std::optional<ExactBase> made_;
};

}  // namespace mmverify::impl::bake::detail
