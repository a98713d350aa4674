// Finds contradictions within one result: signs of a file that was changed, cut or made by hand.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace mmverify::gate {

/// The first contradiction in a member of "results", or nothing. These hold in a consistent one:
///   - the counts of by_kind add up to cases_run and to mismatches, and no kind has more mismatches,
///     declined and allowed cases than cases;
///   - there is a counterexample just if there are mismatches;
///   - `refuted` has mismatches; `proved` and `checked` have none, and have cases;
///   - `proved` has run every case that it expects, declined none and had none allowed; nothing has run more.
/// A member that is absent contradicts nothing: the comparison with a baseline reports it.
/// Domain: an object. Throws NoResult if a count is no whole number of 64 bits.
/// Source: docs/result.schema.json, and the sums that scripts/check-schema adds to it.
std::optional<std::string> contradiction_in(const nlohmann::ordered_json& result);

/// Throws NoResult, which names the place and the law, if one of a run's "results" contradicts itself. A run
/// without "results" passes.
void refuse_contradictions(const nlohmann::ordered_json& run);

}  // namespace mmverify::gate
