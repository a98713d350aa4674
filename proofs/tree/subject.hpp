// A subject of topic tree, built in or in the dock: functions that encode maps, give states back, and read the bytes
// of others.
#pragma once

#include "proofs/engine/topic.hpp"
#include "proofs/micromap/maps.hpp"

namespace mmverify::proofs::tree {

using micromap::Map;
using spec::micromap::bits;
using spec::micromap::Bytes;
using spec::micromap::Format;
using spec::micromap::State;
using spec::micromap::States;

/// An encoded map, in a form that only its subject can read.
struct Code {
  Level level = 0;
  Format format = Format::two_state;
  std::shared_ptr<const void> form;
};

template <class Form>
Code coded(Level n, Format f, Form form) {
  return {n, f, std::make_shared<const Form>(std::move(form))};
}

/// The form of a code.  Domain: the code was made of such a form.
template <class Form>
const Form& form_of(const Code& code) {
  return *static_cast<const Form*>(code.form.get());
}

/// The entry points of a subject; an empty function is a missing entry point.  Every subject has encode and decode.
/// Several threads may call at once.
struct Functions {
  static constexpr char topic[] = "tree";
  std::function<Code(const Map& map)> encode = {};
  std::function<Bytes(const Code& code)> decode = {};
  /// Writes one state for each index below 4^n.
  std::function<void(const Code& code, std::span<const std::uint32_t> index, std::span<std::uint8_t> state)>
      lookup = {};
  /// Writes one state for each pair of barycentrics.
  std::function<void(const Code& code, std::span<const float> u, std::span<const float> v,
                     std::span<std::uint8_t> state)>
      point = {};
  std::function<Bytes(const Code& code)> bytes = {};
  /// Nothing if the bytes are refused.
  std::function<std::optional<Code>(Level n, Format f, std::span<const std::uint8_t> bytes)> open = {};
  /// The number of the tree's bits that a lookup reads.
  std::function<std::uint64_t(const Code& code, std::uint64_t index)> tree_bits_read = {};
  /// Whether the bytes that it writes, and those that it reads, are the paper's: spec::tree::bytes.
  bool writes_paper = false, reads_paper = false;
  Level max_level = 12;
  /// Answers on floats decide no other points, since the index of barycentrics is computed anew each time.
  bool exact_answers() const { return !point; }
};

using Entry = EntryOf<Functions>;
namespace entry {
inline constexpr Entry lookup{"index -> state", [](const Functions& f) { return bool{f.lookup}; }};
inline constexpr Entry point{"barycentrics -> state", [](const Functions& f) { return bool{f.point}; }};
inline constexpr Entry bytes{"bytes", [](const Functions& f) { return f.bytes && f.open; }};
inline constexpr Entry stream{"the paper's bytes",
                              [](const Functions& f) { return f.bytes && f.writes_paper; }};
inline constexpr Entry paper{"the paper's codes read",
                             [](const Functions& f) { return f.open && f.reads_paper; }};
inline constexpr Entry reads{"bits read", [](const Functions& f) { return bool{f.tree_bits_read}; }};
}  // namespace entry

using TreeSubject = SubjectOf<Functions>;
using TreeSubjectPtr = std::shared_ptr<const TreeSubject>;

/// The built-in subjects tree-spec, tree-stream, tree-ranked, tree-stepwise and tree-container.
const std::vector<TreeSubjectPtr>& built_in_subjects();

inline constexpr auto built_in = built_in_of<built_in_subjects>;

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker
/// processes; what goes wrong there comes out of the calls as SubjectBroken.  A map without a code and a code
/// that its own decoder refuses are wrong answers: an empty map, states 255. Throws dock::CannotLoad
/// where its entry points lead from no map to a code or from no code to a map.
TreeSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::tree
