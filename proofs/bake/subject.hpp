// An implementation of topic bake in the dock: what it makes of a base triangle.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "proofs/bake/support.hpp"

namespace mmverify::proofs::bake {

using spec::micromap::State;

/// As Vulkan numbers formats.
enum class Format : std::uint8_t { two_state = 1, four_state = 2 };

struct Baked {
  std::vector<State> states;  ///< of all 4^n micro-triangles, in the order of the index
  bool padded = true;         ///< with zeros, after the last state
};

/// What a subject has.
struct Functions {
  /// None where it does not support the case.  Calls may come from several threads at once.
  std::function<std::optional<Baked>(const Case&, Level, Format)> bake = {};
  bool centroid = false;  ///< its unknown states are those of spec/bake/state.hpp, micro_state
  Support support = {};   ///< cases are drawn inside it
  bool tight = true;      ///< it promises that nothing is unknown but what has to be
};

class BakeSubject : public Subject {
 public:
  BakeSubject(std::string name, std::string about, Functions functions, std::string fingerprint = {})
      : Subject("bake", std::move(name), std::move(about)),
        functions(std::move(functions)),
        fingerprint_(std::move(fingerprint)) {}
  /// It is asked about whole micro-triangles.
  bool exact() const override { return true; }
  std::string fingerprint() const override { return fingerprint_; }

  const Functions functions;

 private:
  std::string fingerprint_;
};
using BakeSubjectPtr = std::shared_ptr<const BakeSubject>;

/// bake-spec, the specification; bake, this project's baker; and two that sample: centre-sample and
/// corner-samples, of which bake.conservative is not true.
const std::vector<BakeSubjectPtr>& built_in_subjects();

/// The built-in subject of that name.  Domain: there is one.
BakeSubjectPtr built_in(const std::string& name);

/// What a mutant does to the states of a map in 4-state.
using Spoil = std::function<void(const Case&, Level, std::vector<State>&)>;

/// `base` with its maps spoiled on purpose, those in 2-state forced from the spoiled ones.
Mutant spoiled(const char* name, const std::string& base, Levels levels, const Spoil& spoil);

/// A subject with one thing broken on purpose.
Mutant mutant(const char* name, const std::string& base, Levels levels,
              const std::function<void(Functions&)>& change);

}  // namespace mmverify::proofs::bake
