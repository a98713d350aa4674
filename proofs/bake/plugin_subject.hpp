// Somebody's shared library, as a subject of topic bake.
#pragma once

#include <string>

#include "proofs/bake/subject.hpp"
#include "subjects/dock/library.hpp"

namespace mmverify::proofs::bake {

/// The subject that a library offers; null where it has no baker.  It runs in worker processes; what goes
/// wrong there comes out of the calls as SubjectBroken.
BakeSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::bake
