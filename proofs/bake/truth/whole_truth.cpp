#include "proofs/bake/truth/whole_truth.hpp"

#include <algorithm>
#include <bit>

#include "proofs/bake/truth/exact_texture.hpp"
#include "spec/bake/whole/state.hpp"

namespace mmverify::proofs::bake {
namespace {

namespace whole = spec::bake::whole;
using spec::micromap::State;

spec::bake::Binary32 bits_of(float x) { return {std::bit_cast<std::uint32_t>(x)}; }

whole::Place place_of(const Case& one, Level n, std::uint32_t index) {
  whole::Place place{{}, n, index, bits_of(one.margin), {bits_of(one.travel[0]), bits_of(one.travel[1])}};
  for (std::size_t k = 0; k < 3; ++k) place.uv[k] = {bits_of(one.uv[2 * k]), bits_of(one.uv[2 * k + 1])};
  return place;
}

/// Calls ask(judge) in numbers of a width; none where they are too narrow.
template <class Ask>
auto asked(WholeWidth width, const whole::WholeTexture& t, const whole::Place& place, Ask ask)
    -> decltype(whole::in_narrowest(t, place, ask)) {
  if (!t.is_supported()) return std::nullopt;
  switch (width) {
    case WholeWidth::bits128: return whole::in_width<whole::Width128>(t, place, ask);
    case WholeWidth::bits256: return whole::in_width<whole::Width256>(t, place, ask);
    case WholeWidth::bits512: return whole::in_width<whole::Width512>(t, place, ask);
    case WholeWidth::narrowest: break;
  }
  return whole::in_narrowest(t, place, ask);
}

/// The state in all mips together.
std::optional<State> state_in(const std::vector<whole::WholeTexture>& mips, const whole::Place& place,
                              WholeWidth width) {
  whole::Marks all = 0;
  for (const whole::WholeTexture& t : mips) {
    const auto marks = asked(width, t, place, [](auto& judge) { return judge.marks(); });
    if (!marks) return std::nullopt;
    // A mip without marks is O.
    all |= *marks == 0 ? whole::not_transparent : *marks;
  }
  if (all == whole::not_opaque) return State::T;
  if (all == whole::not_transparent) return State::O;
  const auto leans =
      asked(width, mips[0], place, [](auto& judge) { return std::optional<bool>(judge.leans()); });
  if (!leans) return std::nullopt;
  return *leans ? State::UO : State::UT;
}

}  // namespace

std::vector<std::optional<State>> whole_states(const Case& one, Level n, const std::vector<std::uint32_t>& at,
                                               WholeWidth width) {
  std::vector<std::optional<State>> states(at.size());
  if (one.rules.contact == spec::bake::Contact::open) return states;
  with_textures(one, [&](const auto& textures) {
    with_mode<spec::Rational>(one, [&](const auto& mode) {
      std::vector<whole::WholeTexture> mips;
      for (const auto& t : textures) mips.emplace_back(t, mode);
      std::transform(at.begin(), at.end(), states.begin(),
                     [&](std::uint32_t index) { return state_in(mips, place_of(one, n, index), width); });
    });
  });
  return states;
}

}  // namespace mmverify::proofs::bake
