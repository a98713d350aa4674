#include "delivery/vectors/families.hpp"

#include <array>

#include "delivery/vectors/families/all.hpp"

namespace mmverify::vectors {

std::span<const FamilyRow> families() {
  static constexpr std::array rows{
      FamilyRow{"index", index::family},
      FamilyRow{"corners", corners::family},
      FamilyRow{"traverse", traverse::family},
      FamilyRow{"packing", packing::family},
      FamilyRow{"special", packing::special_family},
      FamilyRow{"arrays", arrays::family},
      FamilyRow{"trees", trees::family},
      FamilyRow{"vq", vq::family},
      FamilyRow{"bake", bake::family},
      FamilyRow{"attribute", attribute::family},
  };
  return rows;
}

}  // namespace mmverify::vectors
