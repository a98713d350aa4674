// A subject of topic attribute: an implementation of orders, lookups, decimation, mips, baking and compression as
// functions, built in or in the dock.
#pragma once

#include "proofs/attribute/bake/functions.hpp"
#include "proofs/attribute/decimation/functions.hpp"
#include "proofs/attribute/lookup/functions.hpp"
#include "proofs/attribute/mips/functions.hpp"
#include "proofs/attribute/packing/functions.hpp"
#include "proofs/engine/topic.hpp"

namespace mmverify::proofs::attribute {

/// The entry points of a subject; an empty function is a missing entry point.  Several threads may call at once.
struct Functions {
  static constexpr char topic[] = "attribute";
  Level max_level = 16;  ///< the highest level that it is defined at
  bool exact = true;     ///< it computes exactly, so that its answers on cells decide all points
  Orders orders = {};
  Lookup lookup = {};
  Decimation decimation = {};
  Mips mips = {};
  Baking baking = {};
  Compression compression = {};
  bool exact_answers() const { return exact; }
};

using AttributeSubject = SubjectOf<Functions>;
using AttributeSubjectPtr = std::shared_ptr<const AttributeSubject>;

/// The specification attribute-spec; this project's library attribute, batch by batch; and readings of the paper.
const std::vector<AttributeSubjectPtr>& built_in_subjects();

inline constexpr auto built_in = built_in_of<built_in_subjects>;
inline constexpr auto mutant = mutant_of<built_in_subjects>;

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker
/// processes; what goes wrong there comes out of the calls as SubjectBroken.
AttributeSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::attribute
