// Somebody's shared library, as subjects of topic index.
#pragma once

#include <memory>
#include <vector>

#include "proofs/index/subject.hpp"
#include "subjects/dock/library.hpp"

namespace mmverify::proofs::index {

/// The subjects that a library offers, none where it has no entry point of this topic: one that takes
/// binary32 numbers, named as the file, and where it has an entry point for binary64 another, named FILE:f64.
/// Each runs in worker processes; what goes wrong there comes out of the calls as SubjectBroken.
std::vector<IndexSubjectPtr> plugin_subjects(const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::index
