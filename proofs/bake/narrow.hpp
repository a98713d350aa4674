// The specification's numbers in as few bits as hold them.
#pragma once

#include <stdexcept>

#include "spec/rational.hpp"

namespace mmverify::proofs::bake {

/// Rationals within 63 bits: beyond them it throws std::overflow_error or std::range_error, and never rounds.
using Rational64 = boost::rational<boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    63, 63, boost::multiprecision::signed_magnitude, boost::multiprecision::checked, void>>>;

/// f.operator()<Q>() over the narrowest rationals that hold all numbers on the way.
template <class F>
auto in_smallest(F f) {
  try {
    return f.template operator()<Rational64>();
  } catch (const std::overflow_error&) {
  } catch (const std::range_error&) {
  }
  try {
    return f.template operator()<spec::Rational128>();
  } catch (const std::overflow_error&) {
  } catch (const std::range_error&) {
  }
  return f.template operator()<spec::Rational>();
}

}  // namespace mmverify::proofs::bake
