// What the parts of topic index's foreign subjects share, and their rows.
#pragma once

#include <memory>
#include <set>
#include <utility>

#include "proofs/index/subject.hpp"
#include "tests/foreign/inside.hpp"
#include "tests/foreign/inside_curve.hpp"

namespace mmverify::tests::foreign {

// Rounded arithmetic.
InsideRows faults_of_rounding();
InsideRows right_rounding();

class Hand : public proofs::index::IndexSubject {
 public:
  Hand(const char* name, std::set<proofs::index::Entry> entries, Fault fault,
       proofs::index::Arithmetic arithmetic, Level max_level)
      : IndexSubject(name, "by another hand", arithmetic, max_level),
        fault(fault),
        entries_(std::move(entries)) {}
  bool has(proofs::index::Entry e) const override { return entries_.contains(e); }

 protected:
  const Fault fault;

 private:
  const std::set<proofs::index::Entry> entries_;
};

template <class Of, class... Arguments>
InsideFault fault(const char* law, const char* name, const char* wrong, proofs::Levels levels,
                  Arguments... arguments) {
  return {law, name, wrong, std::make_shared<Of>(name, arguments...), levels};
}

}  // namespace mmverify::tests::foreign
