// An implementation of topic traverse in the dock: what it decides of a candidate, a function each.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "proofs/engine/law.hpp"
#include "spec/traverse/decision.hpp"

namespace mmverify::proofs::traverse {

using spec::micromap::State;
using spec::traverse::Api;
using spec::traverse::Combination;
using spec::traverse::Held;
using spec::traverse::Outcome;
using spec::traverse::Undefined;

/// What a subject has; an empty function is an entry point that is missing.  Calls may come from several threads at
/// once.
struct Functions {
  /// Domain: a combination whose outcome is defined.
  std::function<Outcome(const Combination&)> decide = {};
  /// Domain: a candidate that exists.
  std::function<Undefined(const Combination&)> undefined = {};
};

/// An entry point that must be there, as messages call it.
struct Entry {
  const char* name;
  bool (*there)(const Functions&);
};
namespace entry {
inline constexpr Entry decide{"decide", [](const Functions& f) { return bool{f.decide}; }};
inline constexpr Entry undefined{"undefined", [](const Functions& f) { return bool{f.undefined}; }};
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

 private:
  std::string fingerprint_;
};
using TraverseSubjectPtr = std::shared_ptr<const TraverseSubject>;

/// traverse-spec, the specification; traverse, the library's spans; traverse-single, its single values.
const std::vector<TraverseSubjectPtr>& built_in_subjects();

/// The built-in subject of that name.  Domain: there is one.
TraverseSubjectPtr built_in(const std::string& name);

/// A subject with one thing broken on purpose.
Mutant mutant(const char* name, const std::string& base, const std::function<void(Functions&)>& change);

}  // namespace mmverify::proofs::traverse
