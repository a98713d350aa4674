// Somebody's shared library, as a subject of topic toy.
#pragma once

#include <string>

#include "proofs/toy/subject.hpp"
#include "subjects/dock/library.hpp"

namespace mmverify::proofs::toy {

/// The subject that a library offers; null if it has no entry point of this topic.
ToySubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::toy
