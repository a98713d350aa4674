#include "proofs/bake/truth/denial.hpp"

namespace mmverify::proofs::bake {
namespace {

/// The true state to compare a state with.
State against(State got, State lower, State upper) {
  if (got == State::O) return lower;
  if (got == State::T) return upper;
  return upper == State::O ? State::O : lower;
}

}  // namespace

std::optional<Offender> offender_of(const Case& one, Level n, std::vector<State> got,
                                    const std::vector<std::uint32_t>& at, const Truth& truth, Denies denies) {
  std::vector<State> right(at.size());
  for (std::size_t k = 0; k < at.size(); ++k) {
    const State lower = truth.lower[k], upper = truth.upper[k];
    State& state = got[at[k]];
    const bool denied = denies(state, lower, upper);
    right[k] = against(state, lower, upper);
    if (denied && right[k] == state) right[k] = state == State::UO ? State::UT : State::UO;
    if (!denied) state = right[k];
  }
  return worst(one, n, got, at, right);
}

namespace {

std::string place_text(const TexturePoint& p) { return fmt::format("({}, {})", text_of(p.x), text_of(p.y)); }

/// The extent of a wrong O or T as words: a tie, or by how much alpha misses the cutoff and on which share of the
/// area.
std::string amount(const Case& one, Level n, const Offender& o, const Extreme& e) {
  if (is_tie(one, n, o.index, o.said)) return ", a tie: wrong on an area of 0 alone";
  std::string text;
  if (!one.blend) {
    const Rational cutoff = spec::bake::fraction<Rational>(one.cutoff.numerator, one.cutoff.denominator);
    const Rational by = o.said == State::O ? Rational(cutoff - e.alpha) : Rational(e.alpha - cutoff);
    if (by > 0) text = fmt::format(", {} {} the cutoff", text_of(by), o.said == State::O ? "below" : "above");
  }
  if (one.margin == 0 && one.travel == std::array<float, 2>{}) {
    const double share = wrong_share(one, n, o.index, o.said, e.mip);
    text += share == 0 ? std::string(", on less than 1/256 of its area")
                       : fmt::format(", wrong on about {:.0f} % of its area", 100 * share);
  }
  return text;
}

}  // namespace

Words words_of(const Case& one, Level n, const Offender& o) {
  const Extreme& e = contradiction(o);
  return {fmt::format("micro-triangle {} {}, alpha {} at texel {}{}{}", o.index, name_of(o.is),
                      text_of(e.alpha), place_text(e.at), e.mip == 0 ? "" : fmt::format(" of mip {}", e.mip),
                      unknown(o.said) ? std::string() : amount(one, n, o, e)),
          name_of(o.said)};
}

}  // namespace mmverify::proofs::bake
