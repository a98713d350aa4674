// Mips of textures and of their maps, as a table.
#pragma once

#include <string>
#include <vector>

#include "bench/table.hpp"
#include "scene/attribute/mip_errors.hpp"

namespace mmverify::bench {

/// A table with a row for each mip of each set.  Source: Color and Attribute Micromaps, 4.4, figure 7, in
/// texture space.
Table attribute_mips_table(const std::vector<scene::MipStep>& steps);

/// The file of a picture of a mip of an image, drawn by side_by_side() of scene/attribute/picture.hpp.
struct MipPictureFile {
  std::string set, image;  ///< glTF's names of the attributes; the image's name, as files have it
  unsigned mip = 0;
  std::string file;  ///< a path from the folder in which the program was called, or an absolute one
};

/// A table of the pictures of mips that a run wrote.
Table attribute_mip_pictures_table(const std::vector<MipPictureFile>& pictures);

}  // namespace mmverify::bench
