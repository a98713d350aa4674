// All laws and built-in subjects, of all topics.
#pragma once

#include "proofs/engine/law.hpp"
#include "proofs/induction/statement.hpp"

namespace mmverify::proofs {

const std::vector<Law>& laws();

/// Null where there is no such law.
const Law* find_law(const std::string& id);

/// The laws that a name means: an id, a topic, or the part of an id before its dot.  Empty where it means
/// none.
std::vector<const Law*> laws_named(const std::string& name);

/// The highest level that any law is defined at.
Level max_level();

/// The built-in subjects.
std::vector<SubjectPtr> subjects();

/// Null where there is no built-in subject of that name.
SubjectPtr find_subject(const std::string& name);

/// Statements by FOLDER/NAME, a folder a law: "index/floats/index".  proofs/statements.lock has the SHA-256 of each text and
/// the steps that z3 takes to settle it; `mmverify list --statements DIR` writes the texts.
std::map<std::string, induction::Statement> shipped_statements();

}  // namespace mmverify::proofs
