// The rows of the table of faults that MMVERIFY_FAULTS names, in the caller's namespace: included once in each, so without a guard.

enum Fault {
#define MMVERIFY_FAULT(name, wrong, laws) name,
#include MMVERIFY_FAULTS
#undef MMVERIFY_FAULT
};

inline constexpr const char* fault_names[] = {
#define MMVERIFY_FAULT(name, wrong, laws) #name,
#include MMVERIFY_FAULTS
#undef MMVERIFY_FAULT
};

/// Nothing where the environment names no row of the table.
inline const std::optional<int> fault = mmverify::tests::foreign::chosen_fault(fault_names);
inline const int active = fault.value_or(-1);  // one comparison in the loops
inline bool has(Fault f) { return active == static_cast<int>(f); }
