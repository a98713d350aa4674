// Somebody's shared library, as a subject of topic traverse.
#pragma once

#include <string>

#include "proofs/traverse/subject.hpp"
#include "subjects/dock/library.hpp"

namespace mmverify::proofs::traverse {

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker processes; what
/// goes wrong there comes out of the calls as SubjectBroken.
TraverseSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::traverse
