// A subject of topic traverse: functions that decide on candidates and blend hits, built in or in the dock.
#pragma once

#include "display/render/opacity.hpp"
#include "proofs/engine/topic.hpp"
#include "spec/traverse/blend.hpp"
#include "spec/traverse/decision.hpp"

namespace mmverify::proofs::traverse {

using spec::micromap::State;
using spec::traverse::Api;
using spec::traverse::Combination;
using spec::traverse::Held;
using spec::traverse::Hit;
using spec::traverse::Operation;
using spec::traverse::Outcome;
using spec::traverse::Undefined;

/// A hit's distance in the specification's form, and as a number.
constexpr std::uint32_t distance_of(float distance) { return std::bit_cast<std::uint32_t>(distance); }
constexpr float number_of_distance(std::uint32_t distance) { return std::bit_cast<float>(distance); }

/// A lookup of a candidate hit in the sample world's maps of one form; square maps have one level.
struct Looks {
  render::Method method = render::Method::flat;
  unsigned level = 0;
  std::uint32_t geometry = 0, triangle = 0;
  render::Barycentrics at{0, 0};
};

/// The entry points of a subject; an empty function is a missing entry point.  Several threads may call at once.
struct Functions {
  static constexpr char topic[] = "traverse";
  /// Domain: a combination whose outcome is defined.
  std::function<Outcome(const Combination&)> decide = {};
  /// Domain: a candidate that exists.
  std::function<Undefined(const Combination&)> undefined = {};
  /// Blends values into payloads, four codes to a word, R in the lowest byte.  Domain: spans of one size.
  std::function<void(Operation, std::span<const std::uint32_t> payload, std::span<const std::uint32_t> value,
                     std::span<std::uint32_t> out)>
      blend = {};
  /// The payload at a ray's end, from hits in the order in which traversal meets them.
  std::function<spec::traverse::Colour(Operation, const spec::traverse::Colour& payload,
                                       std::span<const Hit>)>
      gather = {};
  /// The state; nothing for a triangle without a map.  Domain: a form, a triangle and a point of the sample world.
  std::function<std::optional<State>(const Looks&)> look = {};
  /// No combinations lie between combinations.
  bool exact_answers() const { return true; }
};

using Entry = EntryOf<Functions>;
namespace entry {
inline constexpr Entry decide{"traverse_decide", [](const Functions& f) { return bool{f.decide}; }};
inline constexpr Entry undefined{"undefined", [](const Functions& f) { return bool{f.undefined}; }};
inline constexpr Entry blend{"traverse_blend", [](const Functions& f) { return bool{f.blend}; }};
inline constexpr Entry gather{"traverse_blend_hits", [](const Functions& f) { return bool{f.gather}; }};
inline constexpr Entry look{"look", [](const Functions& f) { return bool{f.look}; }};
}  // namespace entry

class TraverseSubject final : public SubjectOf<Functions> {
 public:
  using SubjectOf::SubjectOf;
  const std::uint64_t serial = ++made_;  ///< unique in this process

 private:
  static inline std::atomic<std::uint64_t> made_ = 0;
};
using TraverseSubjectPtr = std::shared_ptr<const TraverseSubject>;

/// The specification traverse-spec; the library's spans, traverse, and its single values, traverse-single; and
/// traverse-as-met, which blends hits as it meets them.
const std::vector<TraverseSubjectPtr>& built_in_subjects();

inline constexpr auto built_in = built_in_of<built_in_subjects>;

/// A subject with one deliberate error.
inline Mutant mutant(const char* name, const std::string& base,
                     const std::function<void(Functions&)>& change) {
  return changed(*built_in(base), name, {0, 0}, change);
}

/// The subject that a library offers; null where it has no entry point of this topic.  It runs in worker processes; what
/// goes wrong there comes out of the calls as SubjectBroken.
TraverseSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library);

}  // namespace mmverify::proofs::traverse
