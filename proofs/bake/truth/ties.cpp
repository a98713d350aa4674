#include "proofs/bake/truth/ties.hpp"

#include "proofs/bake/truth/exact_texture.hpp"
#include "proofs/points/narrow.hpp"

namespace mmverify::proofs::bake {

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
  for (std::uint32_t k = 0; k < places; ++k)
    wrong += with_textures(one,
                           [&](const auto& mips) {
                             return in_smallest([&]<class Q>() {
                               const auto& t = mips.at(mip);
                               const auto at = spec::bake::centroid(spec::bake::micro_triangle(
                                   base_triangle<Q>(one), n + finer, index * places + k, t.width, t.height));
                               return with_mode<Q>(one, [&](const auto& mode) {
                                 const Q alpha = spec::bake::alpha(t, at);
                                 return got == State::O ? !mode.opaque(alpha) : !mode.transparent(alpha);
                               });
                             });
                           })
                 ? 1
                 : 0;
  return static_cast<double>(wrong) / places;
}

}  // namespace mmverify::proofs::bake
