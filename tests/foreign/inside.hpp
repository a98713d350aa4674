// Subjects of another hand for laws that no shared library reaches.
#pragma once

#include <vector>

#include "proofs/engine/law.hpp"

namespace mmverify::tests::foreign {

/// A subject that is right, or right but for one fault.
struct InsideFault {
  const char *law, *name, *wrong;  ///< id; an identifier; what is wrong in a sentence, empty for a right one
  proofs::SubjectPtr subject;
  proofs::Levels levels;  ///< refuted within these; a right one passes at all of them
};

// One pair a source.
std::vector<InsideFault> inside_faults_of_index();
std::vector<InsideFault> inside_right_of_index();
std::vector<InsideFault> inside_faults_of_provers();
std::vector<InsideFault> inside_right_of_provers();

}  // namespace mmverify::tests::foreign
