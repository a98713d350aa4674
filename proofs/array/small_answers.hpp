// The answers to all small arrays that a builder gave, judged once for all the laws about them.
#pragma once

#include "proofs/array/law_parts.hpp"

namespace mmverify::proofs::array {

/// The finding of small array k under a check.  A subject that keeps small arrays is asked once for all laws: the first
/// that comes to the case runs every law's check on the answers, and keeps their digest where all hold; then it is the
/// finding under any of them.  Mutants keep none: each law asks them anew.
/// Domain: level n 0 or 1, k < small_arrays(n).
Finding small_array_finding(const ArraySubject& s, Level n, std::uint64_t k, Check check);

/// A place for all small arrays, 9 bytes each, for a subject that is no mutant.
PassedOfSubject small_arrays_of_subject();

}  // namespace mmverify::proofs::array
