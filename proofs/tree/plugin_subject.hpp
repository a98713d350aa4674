// Somebody's shared library, as a subject of topic tree.
#pragma once

#include <string>

#include "proofs/tree/subject.hpp"
#include "subjects/dock/library.hpp"

namespace mmverify::proofs::tree {

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker
/// processes; what goes wrong there comes out of the calls as SubjectBroken.  A map without a code and a code
/// that its own decoder refuses are wrong answers: an empty map, states 255. Throws dock::CannotLoad
/// where its entry points lead from no map to a code or from no code to a map.
TreeSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::tree
