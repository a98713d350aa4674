// A choice that a run makes for the laws that know it.
#pragma once

#include <algorithm>
#include <vector>

namespace mmverify::proofs {

/// Told apart by its address.  A law names those that it heeds; it does not see the others.
struct Option {
  /// Of a run with it, what a result's domain says at its end; null where the domain is the same.
  const char* domain = nullptr;
  /// Leaves cases out.  Laws about the subjects that they name are always about all cases.
  bool narrows = false;
};

using Options = std::vector<const Option*>;

inline bool has(const Options& options, const Option& option) {
  return std::find(options.begin(), options.end(), &option) != options.end();
}

}  // namespace mmverify::proofs
