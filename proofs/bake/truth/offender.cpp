#include "proofs/bake/truth/offender.hpp"

#include <fmt/format.h>

#include "proofs/bake/truth/exact_texture.hpp"
#include "proofs/points/narrow.hpp"

namespace mmverify::proofs::bake {
namespace {

bool is_known(State s) { return s == State::O || s == State::T; }

/// How far alpha is on the other side of what the state says; below 0 where it is not.
Rational depth(const Case& one, const Offender& o) {
  const Rational cutoff = spec::bake::fraction<Rational>(one.cutoff.numerator, one.cutoff.denominator);
  const Rational opaque = one.blend ? Rational(1) : cutoff, transparent = one.blend ? Rational(0) : cutoff;
  return o.said == State::O ? Rational(opaque - o.alpha.least.alpha)
                            : Rational(o.alpha.greatest.alpha - transparent);
}

}  // namespace

std::optional<Offender> worst(const Case& one, Level n, const std::vector<State>& got,
                              const std::vector<std::uint32_t>& at, const std::vector<State>& truth) {
  std::optional<Offender> found;
  Rational most = 0;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const State said = got[at[k]], is = truth[k];
    if (said == is || (found && !is_known(said))) continue;
    const Offender here{at[k], said, is, extremes(one, n, at[k])};
    if (!is_known(said)) {
      found = here;
      continue;
    }
    const Rational d = depth(one, here);
    if (found && is_known(found->said) && d <= most) continue;
    found = here;
    most = d;
  }
  return found;
}

const Extreme& contradiction(const Offender& o) {
  return o.said == State::T ? o.alpha.greatest : o.alpha.least;
}

std::string text_of(const Rational& q) {
  const std::string text =
      q.denominator() == 1 ? q.numerator().str() : q.numerator().str() + "/" + q.denominator().str();
  if (text.size() <= 24) return text;
  return fmt::format("{:.9g}", boost::rational_cast<double>(q));
}

bool is_tie(const Case& one, Level n, std::uint32_t index, State got) {
  Case open = one;
  open.rules.contact = spec::bake::Contact::open;
  const Truth truth = true_states(open, n, {index});
  return got == (got == State::O ? truth.lower : truth.upper).front();
}

double wrong_share(const Case& one, Level n, std::uint32_t index, State got, std::uint32_t mip) {
  constexpr Level finer = 4;
  constexpr std::uint32_t places = 1u << 2 * finer;
  std::uint32_t wrong = 0;
  with_textures(one, [&](const auto& mips) {
    const auto& t = mips.at(mip);
    for (std::uint32_t k = 0; k < places; ++k)
      wrong += in_smallest([&]<class Q>() {
        const auto at = spec::bake::centroid(spec::bake::micro_triangle(
            base_triangle<Q>(one), n + finer, index * places + k, t.width, t.height));
        return with_mode<Q>(one, [&](const auto& mode) {
          const Q alpha = spec::bake::alpha(t, at);
          return got == State::O ? !mode.opaque(alpha) : !mode.transparent(alpha);
        });
      })
                   ? 1
                   : 0;
  });
  return static_cast<double>(wrong) / places;
}

}  // namespace mmverify::proofs::bake
