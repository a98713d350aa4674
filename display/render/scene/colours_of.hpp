// Base colours of a glTF scene as attribute micromaps of its world.
#pragma once

#include <functional>

#include "display/render/attribute/colour_maps.hpp"
#include "display/render/scene/world_of.hpp"
#include "scene/read/attributes.hpp"

namespace mmverify::render {

/// Base colours as attribute micromaps, one map for each triangle with a base colour texture, baked exactly
/// (scene::MapBaker), alpha 255.  Equal triangles of a geometry share a map.  A geometry has no maps if it
/// has no such texture, or if a triangle is beyond scene::within_reach().
/// `done` counts baked triangles, from any thread.
/// Domain: attributes of the scene's own file; level up to 10.
/// Errors: exceptions of `done`.
ColourMaps colours_of(const scene::Scene& scene, const SceneWorld& world,
                      const scene::AttributeScene& attributes, ColoursOf of, unsigned level,
                      unsigned threads = 0, const std::function<void(std::uint64_t)>& done = {});

}  // namespace mmverify::render
