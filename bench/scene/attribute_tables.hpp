// Attribute micromaps of a scene, as tables and a picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/result.hpp"
#include "scene/attribute/measure.hpp"

namespace mmverify::bench {

/// A figure, which may be missing.
inline Property set_key() {
  return text("set", key, "glTF's names of the attributes that see one texture in the same way, joined by +");
}

inline Value optional(const std::optional<double>& x) { return x ? Value(*x) : Value(); }

/// The tables of attribute micromaps.  Source: Color and Attribute Micromaps, table 2, figures 9 and 11.
/// Domain: figures of at least one set, measured with these options.
Result scene_attribute_tables(const scene::AttributeFigures& figures, const scene::AttributeScene& read,
                              const scene::AttributeOptions& options);

/// The file of a picture of an image at a level, drawn by side_by_side() of scene/attribute/picture.hpp.
struct AttributePictureFile {
  std::string set, image;  ///< glTF's names of the attributes; the image's name, as files have it
  unsigned level = 0;
  std::string file;  ///< a path from the folder in which the program was called, or an absolute one
};

/// A table of the pictures that a run wrote.
Table attribute_pictures_table(const std::vector<AttributePictureFile>& pictures);

/// A picture of bytes by level beside the textures, and of FLIP and RMSE of base colours by level and against
/// bytes.
picture::Picture scene_attribute_picture(const scene::AttributeFigures& figures, const std::string& format);

}  // namespace mmverify::bench
