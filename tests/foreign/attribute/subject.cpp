// Written from the paper, docs/ATTRIBUTE*.md and proofs/attribute/*/functions.hpp; each fault of the table is one slip
// inside this code.
#include "tests/foreign/attribute/subject.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "tests/foreign/attribute/faults.hpp"

namespace mmverify::tests::foreign::attribute {

proofs::attribute::AttributeSubjectPtr subject_with(const std::string& fault) {
  Fault wrong = none;
  if (!fault.empty()) {
    const auto* const row = std::find(std::begin(fault_names), std::end(fault_names), fault);
    if (row == std::end(fault_names)) throw std::invalid_argument("no fault is called " + fault);
    wrong = static_cast<Fault>(row - std::begin(fault_names));
  }
  proofs::attribute::Functions f;
  f.exact = false;
  f.orders = orders_with(wrong);
  f.lookup = lookup_with(wrong);
  f.decimation = decimation_with(wrong);
  f.mips = mips_with(wrong);
  f.baking = baking_with(wrong);
  f.compression = packing_with(wrong);
  return std::make_shared<proofs::attribute::AttributeSubject>("foreign-attribute",
                                                               "a stranger's attribute maps", std::move(f));
}

}  // namespace mmverify::tests::foreign::attribute
