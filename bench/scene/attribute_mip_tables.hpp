// Mips of textures and of their maps, as a table.
#pragma once

#include <string>
#include <vector>

#include "bench/table.hpp"
#include "scene/attribute/mip_errors.hpp"

namespace mmverify::bench {

/// A row a mip of each set.  Source: Color and Attribute Micromaps, 4.4, figure 7, in texture space.
Table attribute_mips_table(const std::vector<scene::MipStep>& steps);

/// A picture of a mip of an image, as side_by_side() of scene/attribute/picture.hpp draws it, in a file.
struct MipPictureFile {
  std::string set, image;  ///< glTF's names of the attributes; the image's, as files have it
  unsigned mip = 0;
  std::string file;  ///< a path from the folder that the program was called in, or an absolute one
};

/// Which of them a run wrote.
Table attribute_mip_pictures_table(const std::vector<MipPictureFile>& pictures);

}  // namespace mmverify::bench
