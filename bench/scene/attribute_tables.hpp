// Attribute micromaps of a scene, as tables and a picture.
#pragma once

#include "bench/result.hpp"
#include "scene/attribute/measure.hpp"

namespace mmverify::bench {

/// Source: Color and Attribute Micromaps, table 2, figures 9 and 11.  Domain: figures of at least one set, measured with
/// these options.
Result scene_attribute_tables(const scene::AttributeFigures& figures, const scene::AttributeScene& read,
                              const scene::AttributeOptions& options);

/// Bytes by level beside the textures; FLIP and RMSE of base colours by level, and against bytes.
picture::Picture scene_attribute_picture(const scene::AttributeFigures& figures);

}  // namespace mmverify::bench
