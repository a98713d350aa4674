// Which fault of bake_faults.def the library has.
#pragma once

#include <optional>

#include "tests/foreign/fault.hpp"

#define MMVERIFY_FAULTS "tests/foreign/bake_faults.def"
namespace mmverify::tests::foreign::bake {
#include "tests/foreign/fault_rows.hpp"
}
