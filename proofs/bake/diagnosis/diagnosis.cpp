#include "proofs/bake/diagnosis/diagnosis.hpp"

#include <fmt/ranges.h>

#include "proofs/bake/domains/samples.hpp"
#include "proofs/bake/domains/strata.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/index/diagnosis.hpp"

namespace mmverify::proofs::bake {
namespace {

using spec::micromap::force2;
using spec::micromap::unknown;

/// Whether any judged state of a case is wrong, and whether one is wrong on an area.
struct CaseFaults {
  bool any = false, on_an_area = false;
};

struct Counts {
  std::uint64_t cases = 0, wrong = 0;
};

/// Cases counted by the value of one property, in the order in which the values occur.
struct ByValue {
  const char* of;
  std::vector<std::pair<std::string, Counts>> values;

  Counts& at(const std::string& value) {
    for (auto& [name, counts] : values)
      if (name == value) return counts;
    return values.emplace_back(value, Counts{}).second;
  }
};

bool is_wrong(const BakeSubject& s, Fault fault, State got, State lower, State upper) {
  switch (fault) {
    case Fault::conservative:
      return (got == State::O && lower != State::O) || (got == State::T && upper != State::T);
    case Fault::tight: return unknown(got) && (upper == State::O || lower == State::T);
    case Fault::side: break;
  }
  if (!unknown(got)) return false;
  if (s.functions.centroid) return force2(got) != force2(lower) && force2(got) != force2(upper);
  return got == (s.functions.support.unknown == UnknownSide::opaque ? State::UT : State::UO);
}

/// Known mistakes, scored by the number of wrong maps that they reproduce.
class Guesses {
 public:
  explicit Guesses(Fault fault) : loose_(fault == Fault::conservative) {}
  void take(const Case& one, Level n, const std::vector<State>& got) {
    if (cases_ == most) return;
    ++cases_;
    for (std::size_t k = 0; k < known_mistakes().size(); ++k) {
      Case other = one;
      known_mistakes()[k].mistake(other);
      const auto baked = right_->functions.bake(other, n, Format::four_state);
      const std::array<State, 4>& states = known_mistakes()[k].states;
      const auto alike = [&](State a, State right) {
        const State b = states[static_cast<std::size_t>(right)];
        return a == b || (unknown(a) && (loose_ || unknown(b)));
      };
      right_of_[k] += baked && std::equal(got.begin(), got.end(), baked->states.begin(), alike) ? 1 : 0;
    }
  }
  /// The mistake that explains the most cases, if it explains nine of ten.
  std::optional<std::string> line() const {
    const auto best = std::max_element(right_of_.begin(), right_of_.end());
    if (cases_ == 0 || *best * 10 < cases_ * 9) return std::nullopt;
    return fmt::format("{} of {} wrong maps are as if {}", *best, cases_,
                       known_mistakes()[static_cast<std::size_t>(best - right_of_.begin())].as_if);
  }

 private:
  static constexpr std::uint64_t most = 128;
  const bool loose_;  ///< only an O or a T can be wrong; any other state may be unknown
  BakeSubjectPtr right_ = built_in("bake");
  std::uint64_t cases_ = 0;
  std::vector<std::uint64_t> right_of_ = std::vector<std::uint64_t>(known_mistakes().size());
};

/// The faults of a case; nothing if the subject declined it.
std::optional<CaseFaults> judged(const BakeSubject& s, Fault fault, const Case& one, Level n,
                                 Guesses& guesses) {
  const std::optional<Baked> baked = s.functions.bake(one, n, Format::four_state);
  if (!baked) return std::nullopt;
  const std::vector<std::uint32_t> at = judged_at(one, n);
  const Truth truth = true_states(one, n);
  CaseFaults wrong;
  for (std::size_t k = 0; k < at.size() && !wrong.on_an_area; ++k) {
    const State got = baked->states.at(at[k]);
    if (!is_wrong(s, fault, got, truth.lower[k], truth.upper[k])) continue;
    wrong.any = true;
    wrong.on_an_area = fault != Fault::conservative || !is_tie(one, n, at[k], got);
  }
  if (wrong.any) guesses.take(one, n, baked->states);
  return wrong;
}

/// "filter: nearest (98 of 130) wrong; bilinear all right", if some values are always right and others are not.
std::optional<std::string> in_words(const ByValue& by) {
  constexpr std::uint64_t few = 8;  // fewer cases than this show nothing
  std::vector<std::string> wrong, right;
  for (const auto& [value, counts] : by.values) {
    if (counts.cases < few) continue;
    if (counts.wrong == 0)
      right.push_back(value);
    else
      wrong.push_back(fmt::format("{} ({} of {})", value, counts.wrong, counts.cases));
  }
  if (wrong.empty() || right.empty()) return std::nullopt;
  return fmt::format("{}: wrong where it is {}; all right where it is {}", by.of, fmt::join(wrong, ", "),
                     fmt::join(right, ", "));
}

std::vector<std::string> found(const BakeSubject& s, Fault fault) {
  // Low levels have few known states, and so show little.
  constexpr std::uint64_t samples = 240, rows = 96;
  constexpr Level last = 5;
  std::vector<ByValue> by;
  std::uint64_t cases = 0, proper = 0, ties = 0;
  Guesses guesses(fault);
  const auto take = [&](Case drawn, Level n, std::uint64_t salt) {
    const Case one = fitted(s.functions.support, std::move(drawn), salt);
    const std::optional<CaseFaults> wrong = interrupted() ? std::nullopt : judged(s, fault, one, n, guesses);
    if (!wrong) return;
    ++cases;
    proper += wrong->on_an_area ? 1 : 0;
    ties += wrong->any && !wrong->on_an_area ? 1 : 0;
    const std::vector<Property> properties = properties_of(one, n);
    for (std::size_t p = 0; p < properties.size(); ++p) {
      if (by.size() == p) by.push_back({properties[p].of, {}});
      Counts& counts = by[p].at(properties[p].value);
      ++counts.cases;
      counts.wrong += wrong->any ? 1 : 0;
    }
  };
  for (std::uint64_t k = 0; k < samples; ++k) {
    // Each of the eight kinds of samples occurs at each level.
    const Level n = static_cast<Level>(k / 8 % (last + 1));
    take(sample(1, k), n, k);
    take(featured_sample(1, k), n, k);
    take(large_sample(1, k), last - static_cast<Level>(k % 3), k);
  }
  for (std::uint64_t k = 0; k < rows; ++k)
    take(stratified(1, static_cast<Level>(k % (last + 1)), k), static_cast<Level>(k % (last + 1)), k);

  std::vector<std::string> lines;
  if (proper + ties == 0)
    lines.push_back(
        fmt::format("a rare fault: none of {} other cases of levels 0..{} shows it", cases, last));
  else if (fault == Fault::conservative)
    lines.push_back(
        fmt::format("of {} cases of levels 0..{}, {} have a state that is wrong on an area, {} only ties: a "
                    "contact of area 0",
                    cases, last, proper, ties));
  else
    lines.push_back(fmt::format("of {} cases of levels 0..{}, {} are wrong", cases, last, proper));
  for (const ByValue& one : by)
    if (auto line = in_words(one)) lines.push_back(std::move(*line));
  if (auto line = guesses.line()) lines.push_back(std::move(*line));
  if (lines.size() == 1 && proper + ties != 0)
    lines.emplace_back("no property of a case tells the wrong ones from the right ones");
  const Level n = std::min<Level>(3, s.functions.support.max_level);
  if (const std::string order = n == 0 ? std::string() : order_of(s, n); !order.empty())
    lines.push_back(fmt::format("the order of its micro-triangles at level {}: {}", n, order));
  return lines;
}

constexpr std::uint32_t texels_along = 16;  ///< a micro-triangle's side

/// Transparent, but for four texels about the centroid of a micro-triangle: no other one meets what is sampled of them.
Case dotted(const points::MicroTriangle& m, Level n) {
  Case one;
  one.width = one.height = texels_along << n;
  one.wrap_u = one.wrap_v = Wrap::clamp_to_edge;
  one.uv = {0, 0, 1, 0, 0, 1};
  one.alpha.assign(std::size_t{one.width} * one.height, 0);
  const std::uint32_t third = texels_along * (m.inverted ? 2 : 1) / 3;
  const std::uint32_t i = m.i * texels_along + third, j = m.j * texels_along + third;
  for (const std::uint32_t row : {j - 1, j})
    for (const std::uint32_t column : {i - 1, i}) one.alpha[column + std::size_t{one.width} * row] = 255;
  return one;
}

/// The one micro-triangle that is not transparent; 4^n where it is none, or not the only one.
std::uint32_t dot_of(const Baked& baked) {
  const auto count = static_cast<std::uint32_t>(baked.states.size());
  std::uint32_t found = count;
  for (std::uint32_t k = 0; k < count; ++k) {
    if (baked.states[k] == State::T) continue;
    if (found != count) return count;
    found = k;
  }
  return found;
}

}  // namespace

std::vector<std::string> diagnose(const BakeSubject& s, Fault fault) {
  // The laws of one fault call this one after the other.
  static std::mutex lock;
  static std::map<std::tuple<std::string, std::string, Fault>, std::vector<std::string>> known;
  const std::lock_guard hold(lock);
  auto& lines = known[{s.name(), s.fingerprint(), fault}];
  if (lines.empty()) lines = found(s, fault);
  return lines;
}

std::string order_of(const BakeSubject& s, Level n) {
  const std::uint32_t none = std::uint32_t{1} << 2 * n;
  if (texels_along << n > s.functions.support.max_side) return {};
  bool all = true;
  const std::string order = index::name_order(n, [&](const points::MicroTriangle& m) {
    if (!all) return none;
    const std::optional<Baked> baked =
        s.functions.bake(fitted(s.functions.support, dotted(m, n), 0), n, Format::four_state);
    const std::uint32_t found = baked ? dot_of(*baked) : none;
    all = all && found != none;
    return found;
  });
  return all ? order : std::string();
}

}  // namespace mmverify::proofs::bake
