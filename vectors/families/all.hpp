// Who makes each family; vectors/families.cpp is the table of them.
#pragma once

#include "vectors/table.hpp"

namespace mmverify::vectors {

/// Points and the index of each, in each dialect.  Source: spec/index/index.hpp.
Family index_family();

}  // namespace mmverify::vectors
