// Somebody's shared library, as a subject of topic dag.
#pragma once

#include <string>

#include "proofs/dag/subject.hpp"
#include "subjects/dock/library.hpp"

namespace mmverify::proofs::dag {

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker processes; what
/// goes wrong there comes out of the calls as SubjectBroken.  A scene without a code and a code that its own decoder refuses
/// are wrong answers: a scene without maps, states 255.  Throws dock::CannotLoad where its entry points lead from no scene to
/// a code or from no code to a scene.
DagSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::dag
