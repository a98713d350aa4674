// Which fault of index_faults.def the library has.
#pragma once

#include <optional>

#include "tests/foreign/fault.hpp"

#define MMVERIFY_FAULTS "tests/foreign/index_faults.def"
namespace mmverify::tests::foreign::index {
#include "tests/foreign/fault_rows.hpp"
}
