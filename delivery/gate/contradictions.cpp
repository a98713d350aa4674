#include "delivery/gate/contradictions.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <nlohmann/json.hpp>

#include "delivery/gate/figures.hpp"

namespace mmverify::gate {
namespace {

using Json = nlohmann::ordered_json;
using Number = std::optional<std::uint64_t>;

/// The member as a count; nothing if it is absent.
Number count_in(const Json& object, const char* member) {
  if (!object.contains(member)) return std::nullopt;
  const Json& count = object.at(member);
  if (!count.is_number_integer() || (!count.is_number_unsigned() && count.get<std::int64_t>() < 0))
    throw NoResult(fmt::format("{}: {} where a whole number should be", member, count.dump()));
  return count.get<std::uint64_t>();
}

/// The sums over by_kind.
struct Sums {
  Number cases, mismatches;
  std::uint64_t declined = 0, allowed = 0;
  std::optional<std::string> contradiction;
};

Sums sums_of(const Json& by_kind) {
  Sums sums;
  const auto add = [](Number& sum, const Number& count) {
    if (count) sum = sum.value_or(0) + *count;
  };
  for (const auto& [kind, counts] : by_kind.items()) {
    if (!counts.is_object()) throw NoResult(fmt::format("by_kind.{}: no object", kind));
    const Number cases = count_in(counts, "cases"), mismatches = count_in(counts, "mismatches"),
                 declined = count_in(counts, "declined"), allowed = count_in(counts, "allowed");
    add(sums.cases, cases);
    add(sums.mismatches, mismatches);
    sums.declined += declined.value_or(0);
    sums.allowed += allowed.value_or(0);
    const std::uint64_t judged = cases.value_or(UINT64_MAX);
    if (mismatches.value_or(0) > judged || declined.value_or(0) > judged - mismatches.value_or(0) ||
        allowed.value_or(0) > judged - mismatches.value_or(0) - declined.value_or(0))
      sums.contradiction = fmt::format("{}: more mismatches, declined and allowed cases than cases", kind);
  }
  return sums;
}

std::optional<std::string> unequal_sum(const char* name, const Number& parts, const Number& whole) {
  if (!parts || !whole || *parts == *whole) return std::nullopt;
  return fmt::format("by_kind adds up to {} {}, the result says {}", *parts, name, *whole);
}

std::optional<std::string> against_verdict(const std::string& verdict, const Number& run,
                                           const Number& expected, const Number& mismatches,
                                           const Sums& sums) {
  const bool passed = verdict == "proved" || verdict == "checked";
  if (passed && mismatches.value_or(0) != 0)
    return fmt::format("{}, with {} mismatches", verdict, *mismatches);
  if (passed && run == 0u) return verdict + ", with no case run";
  if (verdict == "refuted" && mismatches == 0u) return "refuted, with 0 mismatches";
  if (verdict != "proved") return std::nullopt;
  if (run && expected && *run != *expected)
    return fmt::format("proved, with {} of {} cases run", *run, *expected);
  if (sums.declined != 0) return fmt::format("proved, with {} cases declined", sums.declined);
  if (sums.allowed != 0) return fmt::format("proved, with {} cases allowed", sums.allowed);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> contradiction_in(const Json& result) {
  const Number run = count_in(result, "cases_run"), expected = count_in(result, "cases_expected"),
               mismatches = count_in(result, "mismatches");
  Sums sums;
  if (result.contains("by_kind") && result.at("by_kind").is_object()) sums = sums_of(result.at("by_kind"));
  if (sums.contradiction) return sums.contradiction;
  if (auto cases = unequal_sum("cases", sums.cases, run)) return cases;
  if (auto wrong = unequal_sum("mismatches", sums.mismatches, mismatches)) return wrong;
  if (run && expected && *run > *expected)
    return fmt::format("{} cases run, more than the {} expected", *run, *expected);

  if (result.contains("counterexample") && mismatches) {
    const bool shown = !result.at("counterexample").is_null();
    if (shown && *mismatches == 0) return "a counterexample, beside 0 mismatches";
    if (!shown && *mismatches != 0)
      return fmt::format("no counterexample, beside {} mismatches", *mismatches);
  }
  if (result.contains("more_counterexamples") && mismatches == 0u)
    return "more counterexamples, beside 0 mismatches";
  if (!result.contains("verdict") || !result.at("verdict").is_string()) return std::nullopt;
  return against_verdict(result.at("verdict").get<std::string>(), run, expected, mismatches, sums);
}

void refuse_contradictions(const Json& run) {
  if (!run.contains("results") || !run.at("results").is_array()) return;
  std::size_t k = 0;
  for (const Json& result : run.at("results")) {
    const std::string place = fmt::format("results[{}]", k++);
    if (!result.is_object()) throw NoResult(place + ": no object");
    std::optional<std::string> why;
    try {
      why = contradiction_in(result);
    } catch (const NoResult& wrong) {
      throw NoResult(fmt::format("{}.{}", place, wrong.what()));
    }
    if (!why) continue;
    const auto named = [&](const char* member) {
      // Names may be any bytes.
      return result.value(member, Json()).dump(-1, ' ', false, Json::error_handler_t::replace);
    };
    throw NoResult(
        fmt::format("{} ({} on {}, level {}) contradicts itself: {}; take the file that mmverify wrote",
                    place, named("law"), named("subject"), named("level"), *why));
  }
}

}  // namespace mmverify::gate
