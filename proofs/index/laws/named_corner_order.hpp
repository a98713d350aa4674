// The name of the order in which a subject gives corners.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "proofs/engine/law.hpp"
#include "proofs/index/subject.hpp"

namespace mmverify::proofs::index {

/// The order that the subject's corners of the first indices of a level are in, in words: "base, +u, +v", "children 0, 2,
/// 3", one of these rearranged, or that they are in none.
std::string name_corner_order(const IndexSubject& subject, Level n);

/// Why the law about a declared order does not apply: none is declared, and which one is found.
std::optional<std::string> declares_no_order(const Subject& subject, Level n);

/// What a subject that is refuted does instead.
std::vector<std::string> diagnose_corner_order(const Subject& subject, const std::vector<Result>& results);

}  // namespace mmverify::proofs::index
