// Which fault of vq_faults.def the library has.
#pragma once

#include <optional>

#include "tests/foreign/fault.hpp"

namespace mmverify::tests::foreign::vq {

enum Fault {
#define MMVERIFY_FAULT(name, wrong, laws) name,
#include "tests/foreign/vq_faults.def"
#undef MMVERIFY_FAULT
};

inline constexpr const char* fault_names[] = {
#define MMVERIFY_FAULT(name, wrong, laws) #name,
#include "tests/foreign/vq_faults.def"
#undef MMVERIFY_FAULT
};

/// Nothing where the environment names no row of the table.
inline const std::optional<int> fault = chosen_fault(fault_names);
inline const int chosen = fault.value_or(-1);  // asked for every region, so without the optional's own flag

inline bool has(Fault f) { return chosen == f; }

}  // namespace mmverify::tests::foreign::vq
