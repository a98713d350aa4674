#include "delivery/gate/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mmverify::gate {
namespace {

/// The rank of a verdict; a better verdict has a higher rank.  An unknown word ranks below all.
int rank(const Value& verdict) { return rank_of_verdict(unquoted(verdict.text)).value_or(-1); }

Change toward(bool better) { return better ? Change::better : Change::worse; }

bool is_speed(Rule rule) { return rule == Rule::speed_more || rule == Rule::speed_less; }

/// How `after` differs from `before`; nothing if they are equal.
std::optional<Change> change_of(Rule rule, const Value& before, const Value& after, double tolerance) {
  if (before.text == after.text) return std::nullopt;
  const double a = before.number, b = after.number;
  const bool close = std::fabs(a - b) <= 1e-9 * std::max(std::fabs(a), std::fabs(b));
  switch (rule) {
    case Rule::verdict: return toward(rank(after) > rank(before));
    case Rule::yes: return toward(after.text == "true");
    case Rule::about_more: return close ? std::nullopt : std::optional(toward(b > a));
    case Rule::about_less: return close ? std::nullopt : std::optional(toward(b < a));
    case Rule::about: return close ? std::nullopt : std::optional(Change::changed);
    case Rule::more: return toward(b > a);
    case Rule::less: return toward(b < a);
    case Rule::speed_more:
    case Rule::speed_less: {
      // A ratio of 0, from a time too short to measure, cannot be compared.
      if (!(a > 0)) return Change::changed;
      if (!(b > 0)) return Change::worse;
      const double gain = rule == Rule::speed_more ? b / a : a / b;
      if (gain * tolerance < 1) return Change::worse;
      return gain > tolerance ? std::optional(Change::faster) : std::nullopt;
    }
    default: return Change::changed;
  }
}

class Comparing {
 public:
  Comparing(Comparison& out, double tolerance) : out_(out), tolerance_(tolerance) {}

  void group(const std::string& name, const std::map<std::string, Value>& before,
             const std::map<std::string, Figure>& after) {
    // A proof's digest comes and goes with the verdict, which is compared itself.
    const auto was = before.find("verdict");
    const auto is = after.find("verdict");
    const bool judged_otherwise =
        was != before.end() && is != after.end() && was->second.text != is->second.value.text;
    for (const auto& [figure, value] : before)
      if (!after.contains(figure) && !(judged_otherwise && figure == "digest"))
        add(Change::gone, name, figure, value.text, "");
    for (const auto& [figure, now] : after) {
      const auto old = before.find(figure);
      if (old == before.end()) {
        if (!(judged_otherwise && figure == "digest")) add(Change::added, name, figure, "", now.value.text);
        continue;
      }
      ++out_.figures;
      out_.speeds += is_speed(now.rule);
      if (const auto change = change_of(now.rule, old->second, now.value, tolerance_))
        add(*change, name, figure, old->second.text, now.value.text);
    }
  }
  void add(Change change, const std::string& group, const std::string& figure, const std::string& before,
           const std::string& after) {
    out_.differences.push_back({change, group, figure, before, after});
  }

 private:
  Comparison& out_;
  double tolerance_;
};

std::string listed(const Settings& settings) {
  std::string all;
  for (const auto& [name, value] : settings)
    all += fmt::format("{}{} {}", all.empty() ? "" : ", ", name, value);
  return all.empty() ? "none" : all;
}

/// Throws NoResult if schema or settings differ from the result's. whose: "the baseline's", for the message.
void refuse_others(const char* whose, const std::string& schema, const Settings& settings,
                   const Figures& result) {
  if (schema != result.schema)
    throw NoResult(fmt::format("the result's schema is {}, {} is {}", result.schema, whose, schema));
  if (settings != result.settings)
    throw NoResult(fmt::format("the runs have different settings: {} {}; the result's {}", whose,
                               listed(settings), listed(result.settings)));
}

/// Whether the group is a result whose law does not apply. Baselines of earlier versions have such groups.
template <class Group, class ValueOf>
bool does_not_apply(const Group& members, ValueOf value_of) {
  const auto verdict = members.find("verdict");
  return verdict != members.end() && is_not_applicable(value_of(verdict->second));
}

}  // namespace

bool Comparison::has_fallen() const {
  return std::any_of(differences.begin(), differences.end(), [](const Difference& d) {
    return d.figure == "verdict" && d.change == Change::worse &&
           (unquoted(d.after) == "refuted" || unquoted(d.after) == "broken");
  });
}

bool Comparison::red() const { return count(Change::faster) != differences.size(); }

std::size_t Comparison::count(Change change) const {
  return static_cast<std::size_t>(std::count_if(differences.begin(), differences.end(),
                                                [&](const Difference& d) { return d.change == change; }));
}

Comparison compare(const Baseline& baseline, const Figures& result, double tolerance) {
  refuse_others("the baseline's", baseline.schema, baseline.settings, result);
  Comparison out;
  Comparing comparing(out, tolerance);
  for (const auto& [name, members] : baseline.groups) {
    if (does_not_apply(members, [](const Value& verdict) { return verdict; })) continue;
    const auto now = result.groups.find(name);
    if (now == result.groups.end())
      comparing.add(Change::gone, name, "", "", "");
    else
      comparing.group(name, members, now->second);
  }
  for (const auto& [name, members] : result.groups) {
    if (does_not_apply(members, [](const Figure& verdict) { return verdict.value; })) continue;
    const auto old = baseline.groups.find(name);
    if (old == baseline.groups.end() ||
        does_not_apply(old->second, [](const Value& verdict) { return verdict; }))
      comparing.add(Change::added, name, "", "", "");
  }
  if (out.speeds != 0 && baseline.processor != result.processor) out.other_processor = baseline.processor;
  std::stable_sort(out.differences.begin(), out.differences.end(),
                   [](const Difference& x, const Difference& y) { return x.change < y.change; });
  return out;
}

void take_better_speeds(Figures& result, const Figures& other) {
  refuse_others("the first run's", result.schema, result.settings, other);
  for (auto& [name, figures] : result.groups) {
    const auto group = other.groups.find(name);
    if (group == other.groups.end()) continue;
    for (auto& [figure, mine] : figures) {
      const auto theirs = group->second.find(figure);
      if (!is_speed(mine.rule) || theirs == group->second.end()) continue;
      const double a = mine.value.number, b = theirs->second.value.number;
      // A time too short to measure leaves a ratio of 0.
      if (b > 0 && (!(a > 0) || (mine.rule == Rule::speed_more ? b > a : b < a)))
        mine.value = theirs->second.value;
    }
  }
}

}  // namespace mmverify::gate
