// The vectors of bakes, held against the library's baker and against samples.

#include "impl/bake/triangles.hpp"
#include "impl/micromap/micromap.hpp"
#include "tests/vectors/reading.hpp"

namespace vectors_bake_test {

using namespace mmverify;
using tests::Reading;
using vectors::Bytes;
namespace bake = impl::bake;

const Reading& bakes() {
  static const Reading all(tests::family("bake"), "bakes");
  return all;
}

bake::Wrap wrap(std::uint32_t k) {
  constexpr bake::Wrap all[] = {bake::Wrap::repeat, bake::Wrap::mirrored_repeat, bake::Wrap::clamp_to_edge,
                                bake::Wrap::clamp_to_border, bake::Wrap::mirror_once};
  return all[k];
}

bake::BaseTriangle uv_of(std::size_t k) {
  const auto uv = bakes().word_list(k, "uv");
  bake::BaseTriangle base;
  for (std::size_t c = 0; c < 3; ++c)
    base[c] = {std::bit_cast<float>(uv[2 * c]), std::bit_cast<float>(uv[2 * c + 1])};
  return base;
}

/// The library's map of these texels.
Bytes baked(std::size_t k, const Bytes& texels, const bake::AlphaMode& mode, float border) {
  bake::Sampling sampling;
  sampling.u = wrap(bakes()(k, "wrap_u"));
  sampling.v = wrap(bakes()(k, "wrap_v"));
  sampling.filter = bakes()(k, "filter") == 0 ? bake::Filter::bilinear : bake::Filter::nearest;
  sampling.border = border;
  const auto width = bakes()(k, "width");
  const bake::Texels view = bake::TexelView<std::uint8_t>{texels.data(), width, bakes()(k, "height"), width};
  const auto n = bakes()(k, "level");
  const std::size_t count = std::size_t{1} << 2 * n;
  Bytes map((count + 3) / 4);
  bake::TriangleBaker({&view, 1}, mode, sampling).bake(uv_of(k), n, map);
  std::vector<impl::micromap::State> states(count);
  impl::micromap::unpack(map, impl::micromap::Format::four_state, states);
  Bytes codes;
  for (const auto s : states) codes.push_back(static_cast<std::uint8_t>(s));
  return codes;
}

bool is_blend(std::size_t k) { return bakes()(k, "mode") == 1; }

TEST(VectorsBake, ClosedStatesAreTheLibrarys) {
  std::size_t states[4] = {};
  for (std::size_t k = 0; k < bakes().size(); ++k) {
    const bake::AlphaMode mode = is_blend(k) ? bake::AlphaMode(bake::Blend{})
                                             : bake::AlphaMode(bake::Mask{bakes().number(k, "cutoff")});
    const Bytes codes = baked(k, bakes().part(k, "texels"), mode, static_cast<float>(bakes()(k, "border")));
    EXPECT_EQ(codes, bakes().part(k, "closed")) << k << ' ' << bakes().about(k);
    for (const std::uint8_t code : codes) ++states[code];
  }
  for (const std::size_t count : states) EXPECT_GT(count, 20u);
}

// Alpha is above c just where 1 - alpha is not 1 - c or more: the library's map of 1 - alpha, its sides exchanged.
TEST(VectorsBake, StatesAboveTheCutoffAreThoseOfTheComplement) {
  for (std::size_t k = 0; k < bakes().size(); ++k) {
    if (is_blend(k)) {
      EXPECT_EQ(bakes().part(k, "above"), bakes().part(k, "closed"));
      continue;
    }
    Bytes texels = bakes().part(k, "texels");
    for (std::uint8_t& texel : texels) texel = static_cast<std::uint8_t>(255 - texel);
    Bytes codes = baked(k, texels, bake::Mask{1 - bakes().number(k, "cutoff")},
                        static_cast<float>(255 - bakes()(k, "border")));
    for (std::uint8_t& code : codes) code ^= 1;
    EXPECT_EQ(codes, bakes().part(k, "above")) << k << ' ' << bakes().about(k);
  }
}

TEST(VectorsBake, OpenStatesDropContactsAlone) {
  std::size_t dropped = 0;
  for (std::size_t k = 0; k < bakes().size(); ++k) {
    const Bytes closed = bakes().part(k, "closed"), open = bakes().part(k, "open");
    const auto gaps = bakes().word_list(k, "gaps");
    ASSERT_EQ(closed.size(), open.size());
    ASSERT_EQ(closed.size(), gaps.size());
    ASSERT_EQ(closed.size(), bakes().word_list(k, "sides").size());
    for (std::size_t m = 0; m < closed.size(); ++m) {
      EXPECT_TRUE(closed[m] == open[m] || (closed[m] >= 2 && open[m] < 2)) << k << ' ' << m;
      // Bilinear alpha is continuous: a state that holds on no area is a tie.
      if (closed[m] != open[m] && bakes()(k, "filter") == 0) {
        EXPECT_EQ(gaps[m], 0u) << k << ' ' << m;
      }
      dropped += closed[m] == open[m] ? 0 : 1;
    }
  }
  EXPECT_GT(dropped, 4u);
}

// A cutoff moved by less than the gap changes no promise, by the library; moved by more, it does somewhere.
TEST(VectorsBake, GapsAreHowMuchAlphaMayBeOff) {
  std::size_t kept = 0, changed = 0;
  for (std::size_t k = 0; k < bakes().size(); ++k) {
    if (is_blend(k)) continue;
    const Bytes closed = bakes().part(k, "closed");
    const auto gaps = bakes().word_list(k, "gaps");
    for (const int by : {-1, 1}) {
      const float cutoff = bakes().number(k, "cutoff"), moved = cutoff + static_cast<float>(by) / 16;
      const Bytes codes =
          baked(k, bakes().part(k, "texels"), bake::Mask{moved}, static_cast<float>(bakes()(k, "border")));
      for (std::size_t m = 0; m < closed.size(); ++m) {
        const bool same = (closed[m] >= 2) == (codes[m] >= 2) && (closed[m] >= 2 || closed[m] == codes[m]);
        if (std::bit_cast<float>(gaps[m]) > 0.0626f) {
          EXPECT_TRUE(same) << k << ' ' << m << ' ' << bakes().about(k);
        }
        (same ? kept : changed) += 1;
      }
    }
  }
  EXPECT_GT(kept, 100u);
  EXPECT_GT(changed, 20u);
}

}  // namespace vectors_bake_test
