// Common parts of the laws of topic attribute: the check of a case, and the cases that it runs on.
#pragma once

#include "proofs/attribute/subject.hpp"
#include "proofs/engine/spoils.hpp"

namespace mmverify::proofs::attribute {

inline constexpr char cam_2[] = "Color and Attribute Micromaps, 3.1, figure 2";
inline constexpr char cam_3[] = "Color and Attribute Micromaps, 3.2, figure 3";
inline constexpr char cam_4[] = "Color and Attribute Micromaps, 4.1, figure 4";

/// The reason why a subject does not fit, if any: most often a missing entry point.
using Lacks = std::function<std::optional<std::string>(const AttributeSubject&)>;

using Entry = EntryOf<Functions>;
Lacks needing(std::vector<Entry> entries);

/// The reason why a law does not apply to a subject at a level: another topic, a level beyond the subject's, or a
/// missing entry point.
Unfit unfit_by(Lacks lacks);

template <class Case>
using Cases = DrawnCasesOf<AttributeSubject, Case>;

/// The law on numbered cases.
template <class Case>
Law on_cases(Law law, Lacks lacks, Cases<Case> cases) {
  law.unfit = unfit_by(std::move(lacks));
  return on_drawn_cases(std::move(law), std::move(cases));
}

}  // namespace mmverify::proofs::attribute
