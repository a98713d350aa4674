#include "vectors/families.hpp"

#include <array>

#include "vectors/families/all.hpp"

namespace mmverify::vectors {

std::span<const FamilyRow> families() {
  static constexpr std::array rows{
      FamilyRow{"index", index_family},
  };
  return rows;
}

}  // namespace mmverify::vectors
