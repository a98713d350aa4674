// The answers to all small arrays that the built-in builders gave, judged once for all the laws about them.
#pragma once

#include "proofs/array/law_parts.hpp"

namespace mmverify::proofs::array {

/// The finding of small array k under a check.  A built-in subject is asked once for all laws: the first that comes to the
/// case runs every law's check on the answer, and keeps the answer's digest where all hold; then it is the finding under
/// any of them.  Other subjects, mutants too, are asked anew by each law.
/// Domain: level n 0 or 1, k < small_arrays(n).
Finding small_array_finding(const ArraySubject& s, Level n, std::uint64_t k, Check check);

}  // namespace mmverify::proofs::array
