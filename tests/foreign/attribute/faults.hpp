// Which fault of attribute_faults.def a subject has.
#pragma once

#include "proofs/attribute/subject.hpp"

namespace mmverify::tests::foreign::attribute {

enum Fault {
  none = -1,
#define MMVERIFY_FAULT(name, wrong, laws) name,
#include "tests/foreign/attribute_faults.def"
#undef MMVERIFY_FAULT
};

inline constexpr const char* fault_names[] = {
#define MMVERIFY_FAULT(name, wrong, laws) #name,
#include "tests/foreign/attribute_faults.def"
#undef MMVERIFY_FAULT
};

using proofs::Level;

// Each part of the topic, with a fault that may be another part's.
proofs::attribute::Orders orders_with(Fault);
proofs::attribute::Lookup lookup_with(Fault);
proofs::attribute::Decimation decimation_with(Fault);
proofs::attribute::Mips mips_with(Fault);
proofs::attribute::Baking baking_with(Fault);
proofs::attribute::Compression packing_with(Fault);

}  // namespace mmverify::tests::foreign::attribute
