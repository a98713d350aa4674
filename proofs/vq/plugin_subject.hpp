// Somebody's shared library, as a subject of topic vq.
#pragma once

#include <string>

#include "proofs/vq/subject.hpp"
#include "subjects/dock/library.hpp"

namespace mmverify::proofs::vq {

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker
/// processes; what goes wrong there comes out of the calls as SubjectBroken.
VqSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::vq
