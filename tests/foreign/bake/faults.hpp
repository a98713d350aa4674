// Which fault of bake_faults.def the library has.
#pragma once

#include <optional>

#include "tests/foreign/fault.hpp"

namespace mmverify::tests::foreign::bake {

enum Fault {
#define MMVERIFY_FAULT(name, wrong, laws) name,
#include "tests/foreign/bake_faults.def"
#undef MMVERIFY_FAULT
};

inline constexpr const char* fault_names[] = {
#define MMVERIFY_FAULT(name, wrong, laws) #name,
#include "tests/foreign/bake_faults.def"
#undef MMVERIFY_FAULT
};

/// Nothing where the environment names no row of the table.
inline const std::optional<int> fault = chosen_fault(fault_names);
inline bool has(Fault f) { return fault == static_cast<int>(f); }

}  // namespace mmverify::tests::foreign::bake
