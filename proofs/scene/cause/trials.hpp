// The changes that a search for a cause has tried, and the best one among them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "proofs/scene/cause/cause.hpp"
#include "proofs/scene/cause/examined.hpp"

namespace mmverify::proofs::scene {

/// So many states have to speak for a change: few states fit many changes by chance.  More are wanted where each record,
/// or each pair of changes, is tried.
inline constexpr std::uint64_t least_evidence = 8, least_evidence_of_many = 16, least_evidence_of_pairs = 48;

class Trials {
 public:
  /// The maps under a change, in the order of `triangles`: the stored ones and the expected ones.
  struct Maps {
    std::vector<States> stored, expected;
  };
  using Make = std::function<Maps(const std::vector<std::size_t>& triangles)>;

  /// Domain: examined outlives it.
  explicit Trials(const Examined& examined) : examined_(examined) {}

  /// Tries a change; keeps it if it explains all triangles, better than those before.  Returns whether it is kept.
  ///   evidence: the states that have to speak for it;  exact: it has to fit each of them
  /// Errors: Interrupted; exceptions of baking, but not those of UVs or factors beyond what can be baked.
  bool attempt(const std::string& code, const std::string& says, const Make& make,
               std::uint64_t evidence = least_evidence, bool exact = false);

  /// Keeps a cause that was found otherwise.
  void keep(Cause cause) { best_ = std::move(cause); }

  const std::optional<Cause>& best() const { return best_; }
  Cause& best_cause() { return *best_; }

  /// Whether the best change fits every known state and leaves none needlessly unknown.
  bool is_exact() const { return best_ && tried_fit_.needless == 0; }
  /// Whether a change of another kind fits nearly as well as the best one, which is not exact.
  bool is_doubtful() const;

 private:
  struct Sum {
    Fit fit;
    std::uint64_t explained = 0;
    bool all_right = true;
  };
  bool fits_first(const Make& make) const;
  Sum sum(const std::vector<std::size_t>& triangles, const Maps& maps) const;
  bool keeps_within_domain(const std::string& code, const std::string& says, const Make& make,
                           std::uint64_t evidence, bool exact);

  const Examined& examined_;
  std::vector<std::pair<std::string, Fit>> fitting_;  ///< codes and fits of the tried triangles
  Fit tried_fit_;
  std::optional<Cause> best_;
};

}  // namespace mmverify::proofs::scene
