// Which fault of index_faults.def the library has.
#pragma once

#include <optional>

#include "tests/foreign/fault.hpp"

namespace mmverify::tests::foreign::index {

enum Fault {
#define MMVERIFY_FAULT(name, wrong, laws) name,
#include "tests/foreign/index_faults.def"
#undef MMVERIFY_FAULT
};

inline constexpr const char* fault_names[] = {
#define MMVERIFY_FAULT(name, wrong, laws) #name,
#include "tests/foreign/index_faults.def"
#undef MMVERIFY_FAULT
};

/// Nothing where the environment names no row of the table.
inline const std::optional<int> fault = chosen_fault(fault_names);
inline const int active = fault.value_or(-1);  // one comparison in the loops
inline bool has(Fault f) { return active == f; }

}  // namespace mmverify::tests::foreign::index
