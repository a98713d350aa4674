// Somebody's shared library, as a subject of topic attribute.
#pragma once

#include <string>

#include "proofs/attribute/subject.hpp"
#include "subjects/dock/library.hpp"

namespace mmverify::proofs::attribute {

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker
/// processes; what goes wrong there comes out of the calls as SubjectBroken.
AttributeSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::attribute
