// Subjects of another hand for laws that no shared library reaches: each is written from the law's statement,
// the papers and the interface header alone, and is right but for one fault.
#pragma once

#include <vector>

#include "proofs/engine/law.hpp"

namespace mmverify::tests::foreign {

/// A law's subject, wrong in one thing, or right.
struct InsideFault {
  const char *law, *name, *wrong;  ///< id; an identifier; what is wrong, in a sentence: empty for a right one
  proofs::SubjectPtr subject;
  proofs::Levels levels;  ///< a fault is refuted within these, a right one passes at each
};
using InsideFaults = std::vector<InsideFault>;

}  // namespace mmverify::tests::foreign
