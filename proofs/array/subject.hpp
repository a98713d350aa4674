// A subject of topic array: an implementation as functions, built in or in the dock.
#pragma once

#include "proofs/engine/passed.hpp"
#include "proofs/engine/topic.hpp"
#include "spec/array/build.hpp"
#include "spec/array/change.hpp"
#include "spec/array/container.hpp"
#include "spec/array/emulate.hpp"

namespace mmverify::proofs::array {

using spec::array::Api;
using spec::array::BuildOptions;
using spec::array::Bundle;
using spec::array::Part;
using spec::array::Target;
using spec::micromap::Bytes;
using spec::micromap::Encoding;
using spec::micromap::Format;
using spec::micromap::Record;
using spec::micromap::State;
using spec::micromap::States;
using spec::micromap::UsageCount;

/// A triangle's map, packed: 4^n states of the format, zeros after the last.
struct PackedMap {
  Level level = 0;
  Format format = Format::four_state;
  Bytes bytes;
  friend bool operator==(const PackedMap&, const PackedMap&) = default;
};

/// The input of a builder.  Each map of `before` already has a record.
struct BuildCase {
  std::vector<PackedMap> before, maps;
  BuildOptions options;
  /// The maps lie from the last to the first with a byte between, equal ones in one place; else each behind the one
  /// before.  Only a builder that gets places of memory sees a difference.
  bool scattered = false;
};

/// The output of a builder: bytes as a build of the API takes them.
struct Answer {
  Bytes records, data, indices;
  std::vector<UsageCount> array_counts, geometry_counts;
  std::string malformed;  ///< why the answer cannot be read, or empty; if set, the rest does not count
};

/// The way to read codes: their encoding, and whether they are in a cluster.
struct Reading {
  Encoding encoding = Encoding::u32;
  bool cluster = false;
};
/// A code, the base triangle of its geometry, and the number of records.
struct Reference {
  std::uint32_t code = 0, base = 0, records = 0;
};

/// The entry points of a subject; an empty function is a missing entry point.  Several threads may call at once.
struct Functions {
  static constexpr char topic[] = "array";
  /// Nothing if the builder refuses.  It may refuse if some index does not fit.
  std::function<std::optional<Answer>(const BuildCase&)> build = {};
  std::function<std::vector<Target>(const Reading&, std::span<const Reference>)> targets = {};
  std::function<Bundle(const Bundle&)> compact = {}, reorder = {};
  std::function<Bundle(const Bundle&, const Bundle&)> concatenate = {};
  std::function<Bytes(const Bundle&, std::uint32_t version)> write = {};
  std::function<std::optional<Bundle>(std::span<const std::uint8_t>)> read = {};
  bool gets_places = false;  ///< `build` gets each map as a place in memory
  /// Files have the bytes of docs/ARRAYS.md; if not, they only have to read back the same.
  bool files_are_ours = true;
  /// A 4-state map of a level above `most`, converted to level `most`.
  std::function<Bytes(Level n, Level most, std::span<const std::uint8_t> four_state)> emulate = {};
  std::function<std::vector<std::uint64_t>(std::span<const std::uint32_t>)> blocks = {};
  PassedOfSubject small_arrays = {};  ///< small_answers.hpp keeps here the ones that passed
  /// No values lie between arrays.
  bool exact_answers() const { return true; }
};

using Entry = EntryOf<Functions>;
namespace entry {
inline constexpr Entry build{"array_build", [](const Functions& f) { return bool{f.build}; }};
inline constexpr Entry targets{"array_resolve", [](const Functions& f) { return bool{f.targets}; }};
inline constexpr Entry compact{"array_compact", [](const Functions& f) { return bool{f.compact}; }};
inline constexpr Entry reorder{"array_reorder", [](const Functions& f) { return bool{f.reorder}; }};
inline constexpr Entry concatenate{"array_concatenate",
                                   [](const Functions& f) { return bool{f.concatenate}; }};
inline constexpr Entry file{"array_save with array_load",
                            [](const Functions& f) { return f.write && f.read; }};
inline constexpr Entry our_file{"load of docs/ARRAYS.md's files",
                                [](const Functions& f) { return f.read && f.files_are_ours; }};
inline constexpr Entry emulate{"array_emulate", [](const Functions& f) { return bool{f.emulate}; }};
inline constexpr Entry blocks{"blocks", [](const Functions& f) { return bool{f.blocks}; }};
}  // namespace entry

using ArraySubject = SubjectOf<Functions>;
using ArraySubjectPtr = std::shared_ptr<const ArraySubject>;

/// array-spec, the specification; array, the library.
const std::vector<ArraySubjectPtr>& built_in_subjects();

inline constexpr auto built_in = built_in_of<built_in_subjects>;
inline constexpr auto mutant = mutant_of<built_in_subjects>;

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker processes; what
/// goes wrong there comes out of the calls as SubjectBroken.  Building and resolving have entry points, the rest none.
ArraySubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::array
