// Where the built-in subjects come from; built_in.cpp lists them.
#pragma once

#include <memory>
#include <vector>

#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

std::shared_ptr<const IndexSubject> impl_subject();
std::vector<std::shared_ptr<const IndexSubject>> row_subjects();

}  // namespace mmverify::proofs::index
