// Which fault of tree_faults.def the library has.
#pragma once

#include <optional>

#include "tests/foreign/fault.hpp"

#define MMVERIFY_FAULTS "tests/foreign/tree_faults.def"
namespace mmverify::tests::foreign::tree {
#include "tests/foreign/fault_rows.hpp"
}
