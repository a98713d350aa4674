// THE table of families: each one's name and the function that makes it.
#pragma once

#include <span>

#include "delivery/vectors/table.hpp"

namespace mmverify::vectors {

struct FamilyRow {
  const char* name;
  Family (*make)();  ///< makes the same family each time
};

/// All families, in the order of the files.
std::span<const FamilyRow> families();

}  // namespace mmverify::vectors
