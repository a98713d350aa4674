// Somebody's shared library, as a subject of topic array.
#pragma once

#include <string>

#include "proofs/array/subject.hpp"
#include "subjects/dock/library.hpp"

namespace mmverify::proofs::array {

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker processes; what
/// goes wrong there comes out of the calls as SubjectBroken.  Building and resolving have entry points, the rest none.
ArraySubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::array
