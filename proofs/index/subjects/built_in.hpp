// Makers of the built-in subjects; built_in.cpp lists them.
#pragma once

#include <memory>
#include <vector>

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

IndexSubjectPtr impl_subject();
std::vector<IndexSubjectPtr> row_subjects();

/// A subject that gives one answer to every question, an index or three corners "(I,J) (I,J) (I,J)".  It judges and
/// draws again an answer of a program on a pipe.  Throws BadCase.
IndexSubjectPtr given_answer(const std::string& answer);

}  // namespace mmverify::proofs::index
