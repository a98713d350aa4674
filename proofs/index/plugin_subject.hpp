// Somebody's shared library, as subjects of topic index.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "proofs/index/subject.hpp"
#include "proofs/isolation/worker.hpp"

namespace mmverify::proofs::index {

/// The subjects that a library offers: one that takes binary32 numbers, named as the file, and where it has
/// an entry point for binary64 another, named FILE:f64.  Each runs in worker processes; what goes wrong there
/// comes out of the calls as SubjectBroken.  Throws isolation::CannotLoad, and std::runtime_error where no
/// process can be had.
std::vector<std::shared_ptr<const IndexSubject>> plugin_subjects(const std::string& library,
                                                                 const isolation::Options& options);

}  // namespace mmverify::proofs::index
