// `mmverify gate` on files of results and baselines: it refuses a file in words, or says what changed.
//
// Input: a byte that the harness ignores (not 'r', after which the mutator sees no JSON), a result's JSON up to a zero
// byte, then the JSON of an earlier result or of a baseline.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "delivery/gate/compare.hpp"
#include "delivery/gate/runs.hpp"

namespace {

using namespace mmverify::gate;
using Json = nlohmann::ordered_json;

constexpr double tolerance = 1.5;

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "result_file: %s\n", what.c_str());
  std::abort();
}

/// A JSON value, read as the command line reads files; nothing for bytes that are none.
std::optional<Json> json_of(const std::uint8_t* first, const std::uint8_t* end) {
  constexpr int deepest = 64;
  bool deep = false;
  Json json = Json::parse(
      first, end,
      [&](int depth, Json::parse_event_t, Json&) {
        deep = deep || depth > deepest;
        return !deep;
      },
      false);
  if (deep || json.is_discarded()) return std::nullopt;
  return json;
}

/// read(json), or nothing for a file that is refused with a reason.
template <class Read>
auto taken(const Json& json, Read read) -> std::optional<decltype(read(json))> {
  try {
    refuse_misfits(json, "input.json");
    return read(json);
  } catch (const NoResult& why) {
    const std::string line = why.what();
    if (line.empty()) fail("a refusal without a reason");
    return std::nullopt;
  }
}

/// A result has not changed against its own baseline, nor has the baseline that is written and read again.
Baseline kept(const Figures& figures) {
  const Baseline baseline = baseline_of(figures);
  const std::string text = to_json(baseline);
  const Json file = Json::parse(text);
  if (!is_baseline(file)) fail("a baseline that is none");
  const Baseline again = baseline_of(file);
  if (to_json(again) != text) fail("a baseline changes as it is written and read");
  for (const Baseline& one : {baseline, again})
    if (const Comparison comparison = compare(one, figures, tolerance); !comparison.differences.empty())
      fail("a result differs from its own baseline: " + comparison.differences.front().group + " " +
           comparison.differences.front().figure);
  return baseline;
}

/// The groups and figures of the differences of a kind.
std::set<std::string> named(const Comparison& comparison, Change change) {
  std::set<std::string> names;
  for (const Difference& d : comparison.differences)
    if (d.change == change) names.insert(d.group + ": " + d.figure);
  return names;
}

/// A group that one of two results lacks is gone one way, and new the other way.
void compare_both_ways(const Figures& now, const Figures& before) {
  try {
    const Comparison forth = compare(baseline_of(before), now, tolerance),
                     back = compare(baseline_of(now), before, tolerance);
    if (named(forth, Change::gone) != named(back, Change::added) ||
        named(forth, Change::added) != named(back, Change::gone))
      fail("gone one way, and not new the other way");
    if (forth.count(Change::worse) != 0 && !forth.red()) fail("worse, and not red");
    if (forth.count(Change::changed) != back.count(Change::changed))
      fail("changed one way, and not the other way");
  } catch (const NoResult&) {
    // Other settings or another schema.
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::uint8_t *const end = data + size, *const first_end = std::find(data + 1, end, std::uint8_t{0});
  const auto now_json = json_of(data + 1, first_end),
             before_json = json_of(std::min(first_end + 1, end), end);
  if (!now_json) return 0;
  const auto now = taken(*now_json, figures_of);
  if (!now) return 0;
  kept(*now);
  if (!before_json) return 0;
  if (is_baseline(*before_json)) {
    const auto read = [](const Json& json) { return baseline_of(json); };
    if (const auto baseline = taken(*before_json, read)) try {
        (void)compare(*baseline, *now, tolerance);
      } catch (const NoResult&) {
        // Other settings or another schema.
      }
  } else if (const auto before = taken(*before_json, figures_of)) {
    compare_both_ways(*now, *before);
  }
  return 0;
}
