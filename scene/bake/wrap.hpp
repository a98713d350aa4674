// The bakers' wrap mode for a sampler's.
#pragma once

#include "impl/bake/texture/wrap.hpp"
#include "scene/scene.hpp"

namespace mmverify::scene {

constexpr impl::bake::Wrap wrap_of(Wrap wrap) noexcept {
  switch (wrap) {
    case Wrap::repeat: return impl::bake::Wrap::repeat;
    case Wrap::mirrored_repeat: return impl::bake::Wrap::mirrored_repeat;
    case Wrap::clamp_to_edge: break;
  }
  return impl::bake::Wrap::clamp_to_edge;
}

}  // namespace mmverify::scene
