// An implementation of topic traverse in the dock: what it decides of a candidate, a function each.
#pragma once

#include <atomic>
#include <bit>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "proofs/engine/law.hpp"
#include "render/opacity.hpp"
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

/// A hit's distance as the specification has it, and back.
constexpr std::uint32_t distance_of(float distance) { return std::bit_cast<std::uint32_t>(distance); }
constexpr float number_of_distance(std::uint32_t distance) { return std::bit_cast<float>(distance); }

/// What a candidate hit asks of the sample world's maps in one form; square maps have one level.
struct Looks {
  render::Method method = render::Method::flat;
  unsigned level = 0;
  std::uint32_t geometry = 0, triangle = 0;
  render::Barycentrics at{0, 0};
};

/// What a subject has; an empty function is an entry point that is missing.  Calls may come from several threads at
/// once.
struct Functions {
  /// Domain: a combination whose outcome is defined.
  std::function<Outcome(const Combination&)> decide = {};
  /// Domain: a candidate that exists.
  std::function<Undefined(const Combination&)> undefined = {};
  /// Payloads and values to payloads, four codes to a word, R in the lowest byte.  Domain: spans of one size.
  std::function<void(Operation, std::span<const std::uint32_t> payload, std::span<const std::uint32_t> value,
                     std::span<std::uint32_t> out)>
      blend = {};
  /// The payload that a ray ends with, of hits in the order in which they are met.
  std::function<spec::traverse::Colour(Operation, const spec::traverse::Colour& payload,
                                       std::span<const Hit>)>
      gather = {};
  /// The state; none of a triangle without a map.  Domain: a form, a triangle and a point of the sample world.
  std::function<std::optional<State>(const Looks&)> look = {};
};

/// An entry point that must be there, as messages call it.
struct Entry {
  const char* name;
  bool (*there)(const Functions&);
};
namespace entry {
inline constexpr Entry decide{"decide", [](const Functions& f) { return bool{f.decide}; }};
inline constexpr Entry undefined{"undefined", [](const Functions& f) { return bool{f.undefined}; }};
inline constexpr Entry blend{"blend", [](const Functions& f) { return bool{f.blend}; }};
inline constexpr Entry gather{"gather", [](const Functions& f) { return bool{f.gather}; }};
inline constexpr Entry look{"look", [](const Functions& f) { return bool{f.look}; }};
}  // namespace entry

class TraverseSubject final : public Subject {
 public:
  TraverseSubject(std::string name, std::string about, Functions functions, std::string fingerprint = {})
      : Subject("traverse", std::move(name), std::move(about)),
        functions(std::move(functions)),
        fingerprint_(std::move(fingerprint)) {}
  /// Combinations have nothing between theirs.
  bool exact() const override { return true; }
  std::string fingerprint() const override { return fingerprint_; }

  const Functions functions;
  const std::uint64_t serial = ++made_;  ///< no other one of this process has it

 private:
  static inline std::atomic<std::uint64_t> made_ = 0;
  std::string fingerprint_;
};
using TraverseSubjectPtr = std::shared_ptr<const TraverseSubject>;

/// traverse-spec, the specification; traverse, the library's spans; traverse-single, its single values; traverse-as-met,
/// which blends hits as it meets them.
const std::vector<TraverseSubjectPtr>& built_in_subjects();

/// The built-in subject of that name.  Domain: there is one.
TraverseSubjectPtr built_in(const std::string& name);

/// A subject with one thing broken on purpose.
Mutant mutant(const char* name, const std::string& base, const std::function<void(Functions&)>& change);

}  // namespace mmverify::proofs::traverse
