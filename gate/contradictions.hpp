// What one result says against itself: a file that was changed, cut or made by hand.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace mmverify::gate {

/// What a member of "results" says against itself, or nothing:
///   - the counts of by_kind add up to cases_run and to mismatches, and no kind has more mismatches,
///     declined and allowed cases than cases;
///   - there is a counterexample just where there are mismatches;
///   - `refuted` has mismatches; `proved` and `checked` have none, and have cases, but for a shard's empty share;
///   - `proved` has run every case that it expects, declined none and had none allowed; nothing has run more.
/// A member that is absent contradicts nothing: the comparison with a baseline says that it is gone.
/// Domain: an object.  Throws NoResult where a count is no whole number of 64 bits.
/// Source: docs/result.schema.json, and the sums that scripts/check-schema adds to it.
std::optional<std::string> contradiction_in(const nlohmann::ordered_json& result);

/// Throws NoResult, which names the place and the law, where one of a run's "results" contradicts itself.
/// A run without "results" has none.
void refuse_contradictions(const nlohmann::ordered_json& run);

}  // namespace mmverify::gate
