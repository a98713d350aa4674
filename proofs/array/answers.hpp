// A builder's answer, read as a traversal reads it; no part of it is trusted.
#pragma once

#include "proofs/array/cases.hpp"

namespace mmverify::proofs::array {

/// "special UT", "record 3", "no record 3".
std::string text_of(const Target& to);

/// The answer in bytes that begin with an mmverify_array_answer; `malformed` says why they cannot be read.
Answer read_answer(std::span<const std::uint8_t> bytes);

std::uint64_t record_count(const Answer& a);

/// The target that triangle t's code names.  Domain: the answer has an index for each triangle, see shape().
Target target_of(const Answer& a, const BuildCase& c, std::size_t t);

/// The map of a record, or the reason why it cannot be read.
struct ReadMap {
  Record record{};
  States states;
  std::string unreadable;
};
ReadMap read_map(const Answer& a, std::uint64_t record);

/// The finding for an answer that no law can be checked on: bytes that cannot be read, or missing indices. A refusal
/// is wrong if every index fits.  Nothing for a complete answer.
std::optional<Finding> shape(const std::optional<Answer>& a, const BuildCase& c);

/// A number for the answer, which goes into the digest.
std::uint64_t digest_of(const Answer& a);

// The checks of the laws of building.  Domain: answers that shape() finds complete.
Finding resolves(const Answer& a, const BuildCase& c);
Finding keeps_formats(const Answer& a, const BuildCase& c);
Finding uses_special_indices(const Answer& a, const BuildCase& c);
Finding stays_in_range(const Answer& a, const BuildCase& c);
Finding counts_records(const Answer& a, const BuildCase& c);
Finding counts_references(const Answer& a, const BuildCase& c);
Finding shares(const Answer& a, const BuildCase& c);
Finding keeps_what_was_there(const Answer& a, const BuildCase& c);

}  // namespace mmverify::proofs::array
