// The specification's point -> index algorithms as types, so that one subject template serves them all.
#pragma once

#include "spec/index/index.hpp"

namespace mmverify::proofs::index {

struct ReferenceAlgorithm {
  template <spec::Number Q>
  static std::uint32_t at(const spec::Point<Q>& p, spec::Level n) {
    return spec::index::reference(p, n);
  }
  /// 32-bit words still: what is beyond them is lost.
  template <spec::Number Q>
  static std::uint64_t wide_at(const spec::Point<Q>& p, spec::Level n) {
    return spec::index::reference(p, n);
  }
};

struct ProseAlgorithm {
  template <spec::Number Q>
  static std::uint32_t at(const spec::Point<Q>& p, spec::Level n) {
    return spec::index::as_the_prose_says(p, n);
  }
};

struct WideAlgorithm {
  template <spec::Number Q>
  static std::uint32_t at(const spec::Point<Q>& p, spec::Level n) {
    return static_cast<std::uint32_t>(spec::index::reference_wide(p, n));
  }
  template <spec::Number Q>
  static std::uint64_t wide_at(const spec::Point<Q>& p, spec::Level n) {
    return spec::index::reference_wide(p, n);
  }
};

template <spec::index::Reading reading>
struct StepAlgorithm {
  template <spec::Number Q>
  static std::uint32_t at(const spec::Point<Q>& p, spec::Level n) {
    return spec::index::step<reading>(p, n);
  }
  template <spec::Number Q>
  static std::uint64_t wide_at(const spec::Point<Q>& p, spec::Level n) {
    return spec::index::step<reading, std::uint64_t>(p, n);
  }
};

}  // namespace mmverify::proofs::index
