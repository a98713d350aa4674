// A subject of topic dag, built in or in the dock: functions that build a graph of a scene's maps, give the maps and
// their states back, and read the bytes of others.
#pragma once

#include "proofs/engine/topic.hpp"
#include "spec/dag/words.hpp"

namespace mmverify::proofs::dag {

using spec::micromap::bits;
using spec::micromap::Bytes;
using spec::micromap::Format;
using spec::micromap::State;
using spec::micromap::States;

/// A map, packed: 4^n states of its scene's format.
struct Map {
  Level level = 0;
  Bytes packed;
  friend bool operator==(const Map&, const Map&) = default;
};

/// Maps of one format, in the order in which they are added.
struct Scene {
  Format format = Format::two_state;
  std::vector<Map> maps;
  friend bool operator==(const Scene&, const Scene&) = default;
};

/// A graph, in a form that only its subject can read.
struct Code {
  Format format = Format::two_state;
  std::shared_ptr<const void> form;
};

template <class Form>
Code coded(Format f, Form form) {
  return {f, std::make_shared<const Form>(std::move(form))};
}

/// The form of a code.  Domain: the code was made of such a form.
template <class Form>
const Form& form_of(const Code& code) {
  return *static_cast<const Form*>(code.form.get());
}

using Numbers = std::span<const std::uint32_t>;

/// The entry points of a subject; an empty function is a missing entry point.  Every subject has encode and decode.
/// Several threads may call at once.
struct Functions {
  static constexpr char topic[] = "dag";
  std::function<Code(const Scene& scene)> encode = {};
  std::function<Scene(const Code& code)> decode = {};
  /// Writes one state for each element: that of map[k] at index[k].
  std::function<void(const Code& code, Numbers map, Numbers index, std::span<std::uint8_t> state)> lookup =
      {};
  std::function<void(const Code& code, Numbers map, std::span<const float> u, std::span<const float> v,
                     std::span<std::uint8_t> state)>
      point = {};
  std::function<Bytes(const Code& code)> bytes = {};
  /// Nothing if the bytes are refused.
  std::function<std::optional<Code>(Format f, std::span<const std::uint8_t> bytes)> open = {};
  /// Whether the bytes that it writes, and those that it reads, are docs/DAG.md's containers.
  bool writes_container = false, reads_container = false;
  Level max_level = 12;
  /// Answers on floats decide no other points, since the index of barycentrics is computed anew each time.
  bool exact_answers() const { return !point; }
};

using Entry = EntryOf<Functions>;
namespace entry {
inline constexpr Entry lookup{"map, index -> state", [](const Functions& f) { return bool{f.lookup}; }};
inline constexpr Entry point{"map, barycentrics -> state", [](const Functions& f) { return bool{f.point}; }};
inline constexpr Entry decode{"any code -> maps", [](const Functions& f) { return f.bytes && f.open; }};
inline constexpr Entry container{"maps -> container of docs/DAG.md",
                                 [](const Functions& f) { return f.bytes && f.writes_container; }};
inline constexpr Entry reads{"container of docs/DAG.md -> maps",
                             [](const Functions& f) { return f.open && f.reads_container; }};
}  // namespace entry

using DagSubject = SubjectOf<Functions>;
using DagSubjectPtr = std::shared_ptr<const DagSubject>;

/// The built-in subjects dag-spec, dag and dag-loaded.
const std::vector<DagSubjectPtr>& built_in_subjects();

inline constexpr auto built_in = built_in_of<built_in_subjects>;

/// The state of micro-triangle k.  Domain: k < 4^level.
inline std::uint8_t state_at(const Map& map, Format f, std::uint64_t k) {
  const unsigned b = bits(f);
  return static_cast<std::uint8_t>(map.packed[k * b / 8] >> k * b % 8 & (b == 1 ? 1 : 3));
}

inline States states_of(const Map& map, Format f) {
  return spec::micromap::unpack(map.packed, f, spec::micromap::micro_triangles(map.level));
}

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker processes; what
/// goes wrong there comes out of the calls as SubjectBroken.  A scene without a code and a code that its own decoder refuses
/// are wrong answers: a scene without maps, states 255.  Throws dock::CannotLoad where its entry points lead from no scene to
/// a code or from no code to a scene.
DagSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::dag
