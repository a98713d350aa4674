// Where the built-in subjects come from; built_in.cpp lists them.
#pragma once

#include <memory>
#include <vector>

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

IndexSubjectPtr impl_subject();
std::vector<IndexSubjectPtr> row_subjects();

/// Gives one answer to everything, an index or "(I,J) (I,J) (I,J)", three corners: what a program on a pipe said, judged
/// and drawn again.  Throws BadCase.
IndexSubjectPtr given_answer(const std::string& answer);

}  // namespace mmverify::proofs::index
