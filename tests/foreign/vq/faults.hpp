// Which fault of vq_faults.def the library has.
#pragma once

#include <optional>

#include "tests/foreign/fault.hpp"

#define MMVERIFY_FAULTS "tests/foreign/vq_faults.def"
namespace mmverify::tests::foreign::vq {
#include "tests/foreign/fault_rows.hpp"
}
