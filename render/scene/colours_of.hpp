// Base colours of a glTF scene as attribute micromaps of its world.
#pragma once

#include <functional>
#include <optional>

#include "render/attribute/colour_maps.hpp"
#include "render/scene/world_of.hpp"
#include "scene/read/attributes.hpp"

namespace mmverify::render {

/// A map of each triangle whose material has a base colour texture, baked exactly (scene::MapBaker), alpha 255; equal
/// triangles of a geometry share one.  Without maps are geometries without such a texture, and those with a triangle
/// beyond scene::within_reach().
/// Domain: attributes of the scene's own file; level up to 10.
/// Errors: what `done`, told of triangles from any thread, throws.
ColourMaps colours_of(const scene::Scene& scene, const SceneWorld& world,
                      const scene::AttributeScene& attributes, ColoursOf of, unsigned level,
                      unsigned threads = 0, const std::function<void(std::uint64_t)>& done = {});

}  // namespace mmverify::render
