// THE table of families: a name, and who makes it.
#pragma once

#include <span>
#include <string>

#include "vectors/table.hpp"

namespace mmverify::vectors {

struct FamilyRow {
  const char* name;
  Family (*make)();  ///< the same each time
};

/// All families, in the order in which files list them.
std::span<const FamilyRow> families();

}  // namespace mmverify::vectors
