// A set of values of an enumeration, for the support of a subject.
#pragma once

#include <cstdint>

namespace mmverify::proofs {

/// A set of values below 32.
class Set {
 public:
  constexpr Set() = default;
  constexpr explicit Set(std::uint32_t bits) : bits_(bits) {}
  template <class Value>
  constexpr bool has(Value value) const {
    return (bits_ >> static_cast<unsigned>(value) & 1) != 0;
  }
  friend constexpr bool operator==(Set, Set) = default;

 private:
  std::uint32_t bits_ = ~std::uint32_t{0};  ///< all
};

}  // namespace mmverify::proofs
