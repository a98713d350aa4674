// Names of the orders in which a subject may give corners.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/engine/law.hpp"
#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// The order of the subject's corners of the first indices of a level, in words: "base, +u, +v", "children 0, 2, 3",
/// one of these permuted, or no common order.
std::string name_corner_order(const IndexSubject& subject, Level n);

/// The reason why the law about a declared order does not apply: none is declared; it names the order that was found.
std::optional<std::string> declares_no_order(const Subject& subject, Level n);

/// The diagnosis of a refuted subject: its order of corners at the first refuted level.
std::vector<std::string> diagnose_corner_order(const Subject& subject, const std::vector<Result>& results);

}  // namespace mmverify::proofs::index
