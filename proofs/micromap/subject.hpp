// A subject of topic micromap: an implementation as functions on bytes, built in or in the dock.
#pragma once

#include "proofs/engine/topic.hpp"
#include "spec/micromap/level.hpp"
#include "spec/micromap/validate.hpp"

namespace mmverify::proofs::micromap {

using spec::micromap::Bytes;
using spec::micromap::Encoding;
using spec::micromap::Format;
using spec::micromap::Input;
using spec::micromap::Meaning;
using spec::micromap::Mode;
using spec::micromap::Options;
using spec::micromap::State;
using spec::micromap::States;
using spec::micromap::UsageCount;
using spec::micromap::Violation;

/// A map, packed: 4^n states of the format.
struct PackedMap {
  Level level = 0;
  Format format = Format::four_state;
  Bytes bytes;
};

/// The array that a subject builds from a geometry's maps.
struct Built {
  Bytes records, data, indices;
  std::vector<UsageCount> array_counts, geometry_counts;
};

/// The rules of lossy substitution, and whether each holds between two maps.
struct LossyRules {
  bool allowed = false, conservative = false, force2_stable = false;
  friend bool operator==(const LossyRules&, const LossyRules&) = default;
};

/// The entry points of a subject; an empty function is a missing entry point.  Several threads may call at once.
/// Packed bytes are LSB first; a subject gets padding bits of any value and gives zeros.  Level and format are those
/// of the input.
struct Functions {
  static constexpr char topic[] = "micromap";
  std::function<Bytes(Format f, const States& states)> pack = {};
  std::function<States(Format f, std::uint64_t count, std::span<const std::uint8_t> bytes)> unpack = {};
  std::function<Bytes(Level n, std::span<const std::uint8_t> four_state)> force2 = {};
  std::function<Bytes(Level n, std::span<const std::uint8_t> two_state)> widen = {};
  /// The map one level up or down.
  std::function<Bytes(Level n, Format f, std::span<const std::uint8_t> bytes)> up = {}, down = {};
  /// The map through a 1-bit mode and back.
  std::function<Bytes(Level n, Mode mode, std::span<const std::uint8_t> four_state)> through = {};
  std::function<std::uint32_t(State s, Encoding e)> special_code = {};
  std::function<Meaning(std::uint32_t code, Encoding e)> meaning = {};
  /// The map that a lossy codec gives for a map.
  std::function<Bytes(Level n, std::span<const std::uint8_t> four_state)> substitute = {};
  /// The rules that a substitution keeps.
  std::function<LossyRules(Level n, std::span<const std::uint8_t> was, std::span<const std::uint8_t> is)>
      judge = {};
  /// Appends to an array in which every map of `before` has a record of its own.
  std::function<Built(std::span<const PackedMap> before, std::span<const PackedMap> maps,
                      const Options& options)>
      build = {};
  std::function<std::vector<Violation>(const Input& in)> validate = {};
  /// No values lie between maps.
  bool exact_answers() const { return true; }
};

using Entry = EntryOf<Functions>;
namespace entry {
inline constexpr Entry pack{"micromap_pack with micromap_unpack",
                            [](const Functions& f) { return f.pack && f.unpack; }};
inline constexpr Entry force2{"micromap_force2 with micromap_widen",
                              [](const Functions& f) { return f.force2 && f.widen; }};
inline constexpr Entry up{"micromap_up", [](const Functions& f) { return bool{f.up}; }};
inline constexpr Entry down{"micromap_down", [](const Functions& f) { return bool{f.down}; }};
inline constexpr Entry modes{"micromap_through", [](const Functions& f) { return bool{f.through}; }};
inline constexpr Entry special{"special", [](const Functions& f) { return f.special_code && f.meaning; }};
inline constexpr Entry substitute{"micromap_substitute",
                                  [](const Functions& f) { return bool{f.substitute}; }};
inline constexpr Entry judge{"judge", [](const Functions& f) { return bool{f.judge}; }};
inline constexpr Entry build{"build", [](const Functions& f) { return bool{f.build}; }};
inline constexpr Entry validate{"validate", [](const Functions& f) { return bool{f.validate}; }};
}  // namespace entry

using MicromapSubject = SubjectOf<Functions>;
using MicromapSubjectPtr = std::shared_ptr<const MicromapSubject>;

/// The specification micromap-spec; the library micromap; and three lossy codecs: lossy-stable, lossy-conservative,
/// lossy-merge.
const std::vector<MicromapSubjectPtr>& built_in_subjects();

inline constexpr auto built_in = built_in_of<built_in_subjects>;
inline constexpr auto mutant = mutant_of<built_in_subjects>;

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker
/// processes; what goes wrong there comes out of the calls as SubjectBroken.  Special indices, arrays and
/// their validation have no entry points.
MicromapSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::micromap
