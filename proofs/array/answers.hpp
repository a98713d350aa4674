// What a builder's answer says, read as a traversal reads it; nothing of it is believed.
#pragma once

#include <optional>
#include <string>

#include "proofs/array/cases.hpp"
#include "proofs/engine/cases.hpp"

namespace mmverify::proofs::array {

/// "special UT", "record 3", "no record 3".
std::string text_of(const Target& to);

std::uint64_t record_count(const Answer& a);

/// What triangle t's code means.  Domain: an index for each triangle is there, see shape().
Target target_of(const Answer& a, const BuildCase& c, std::size_t t);

/// The map of a record, or why it cannot be read.
struct ReadMap {
  Record record{};
  States states;
  std::string unreadable;
};
ReadMap read_map(const Answer& a, std::uint64_t record);

/// Why an answer has not the shape of one: what cannot be read, indices that are missing; else nothing.  A refusal is
/// one, too, where every index fits.
std::optional<Finding> shape(const std::optional<Answer>& a, const BuildCase& c);

/// Of one answer, for the digest.
std::uint64_t digest_of(const Answer& a);

// The checks of the laws of building.  Domain: answers that shape() finds nothing wrong with.
Finding resolves(const Answer& a, const BuildCase& c);
Finding keeps_formats(const Answer& a, const BuildCase& c);
Finding uses_special_indices(const Answer& a, const BuildCase& c);
Finding stays_in_range(const Answer& a, const BuildCase& c);
Finding counts_records(const Answer& a, const BuildCase& c);
Finding counts_references(const Answer& a, const BuildCase& c);
Finding shares(const Answer& a, const BuildCase& c);
Finding keeps_what_was_there(const Answer& a, const BuildCase& c);

}  // namespace mmverify::proofs::array
