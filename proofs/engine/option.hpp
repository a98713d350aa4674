// An option of a run, for the laws that know it.
#pragma once

#include <algorithm>
#include <vector>

namespace mmverify::proofs {

/// An option, identified by its address.  A law names the options that it heeds, and does not see others.
struct Option {
  /// The words that a run with it appends to a result's domain; null if the domain is the same.
  const char* domain = nullptr;
  /// The option leaves cases out.  A law about named subjects is always about all cases.
  bool narrows = false;
};

using Options = std::vector<const Option*>;

inline bool has(const Options& options, const Option& option) {
  return std::find(options.begin(), options.end(), &option) != options.end();
}

}  // namespace mmverify::proofs
