// Somebody's shared library, as a subject of topic micromap.
#pragma once

#include <string>

#include "proofs/micromap/subject.hpp"
#include "subjects/dock/library.hpp"

namespace mmverify::proofs::micromap {

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker
/// processes; what goes wrong there comes out of the calls as SubjectBroken.  Special indices, arrays and
/// their validation have no entry points.
MicromapSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::micromap
