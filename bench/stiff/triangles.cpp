// Stiff triangles in textures of 8 bits, for bakers.
#include "impl/bake/triangles.hpp"

#include <bit>
#include <cmath>

#include "bench/bake/obvious.hpp"
#include "bench/stiff/parts.hpp"
#include "spec/bake/state.hpp"

namespace mmverify::bench::stiff {
namespace {

namespace baking = impl::bake;
using baking::BaseTriangle;

constexpr std::uint32_t bake_level = 3, states_a_map = 1u << 2 * bake_level;
constexpr std::uint64_t samples_a_triangle = 1024, fewest_triangles = 16;

struct Textured {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> texels = {};
  baking::Cutoff cutoff = {};
  BaseTriangle uv = {};
};

/// A multiple of 2^-bits in [-reach, reach], exact in binary32.
float dyadic(Random& random, int reach, int bits) {
  const std::int64_t limit = std::int64_t{reach} << bits;
  const auto k = static_cast<std::int64_t>(below(random, static_cast<std::uint64_t>(2 * limit) + 1)) - limit;
  return std::ldexp(static_cast<float>(k), -bits);
}

template <class Draw>
void each_coordinate(Textured& one, Draw draw) {
  for (baking::TexturePoint& p : one.uv) {
    p.u = draw(one.width);
    p.v = draw(one.height);
  }
}

/// Sides of 2 to 7 texels, noise or 0 and 255; the cutoff 1/2 or any code; the corners within two repeats.
Textured ordinary_triangle(Random& random) {
  Textured one;
  one.width = static_cast<std::uint32_t>(2 + below(random, 6));
  one.height = static_cast<std::uint32_t>(2 + below(random, 6));
  if (coin(random)) one.cutoff = {static_cast<std::uint32_t>(1 + below(random, 255)), 255};
  const bool noise = coin(random);
  for (std::uint32_t k = 0; k < one.width * one.height; ++k)
    one.texels.push_back(static_cast<std::uint8_t>(noise ? below(random, 256) : 255 * below(random, 2)));
  each_coordinate(one, [&](std::uint32_t) { return dyadic(random, 2, 8); });
  return one;
}

/// The third corner lies beside the line of the others, by 2^-20 of their distance.
Textured sliver(Random& random) {
  Textured one = ordinary_triangle(random);
  auto& [p, q, r] = one.uv;
  const float across = q.u - p.u, down = q.v - p.v, t = static_cast<float>(below(random, 9)) / 8;
  r = {p.u + t * across - down * 0x1p-20f, p.v + t * down + across * 0x1p-20f};
  return one;
}

/// Most texels equal the cutoff or are a step beside it; or alpha passes it midway between texels, and the corners lie
/// on the lines of texels and of their centres.
Textured meets_cutoff(Random& random) {
  Textured one = ordinary_triangle(random);
  if (coin(random)) {
    const auto code = static_cast<std::uint32_t>(1 + below(random, 254));
    one.cutoff = {code, 255};
    for (std::uint8_t& texel : one.texels) texel = static_cast<std::uint8_t>(code - 1 + below(random, 3));
    return one;
  }
  one.cutoff = {1, 2};
  for (std::uint8_t& texel : one.texels) texel = static_cast<std::uint8_t>(255 * below(random, 2));
  each_coordinate(one, [&](std::uint32_t side) {
    return static_cast<float>(below(random, 4 * side + 1)) / static_cast<float>(2 * side);
  });
  return one;
}

/// Corners on sixteenths of a repeat, which binary32 still holds at 10^6.
Textured repeated(Random& random) {
  Textured one = ordinary_triangle(random);
  const float right = coin(random) ? 1e6f : -1e6f, below_it = coin(random) ? 1e6f : -1e6f;
  for (baking::TexturePoint& p : one.uv) p = {right + dyadic(random, 2, 4), below_it + dyadic(random, 2, 4)};
  return one;
}

/// At (0, 0) bilinear alpha is the mean of the texture's corners, three times in four the cutoff.
Textured subnormal_uv(Random& random) {
  Textured one = ordinary_triangle(random);
  const std::size_t last = one.width - 1, row = std::size_t{one.width} * (one.height - 1);
  if (below(random, 4) != 0)
    one.cutoff = {std::uint32_t{one.texels[0]} + one.texels[last] + one.texels[row] + one.texels[row + last],
                  1020};
  each_coordinate(one, [&](std::uint32_t) { return (coin(random) ? 1.0f : -1.0f) * subnormal(random); });
  return one;
}

template <class Q>
std::uint8_t exact_state(const spec::bake::Texture& t, const Textured& one, std::uint32_t index) {
  const auto vertex = [&](std::size_t k) {
    return spec::bake::place<Q>({std::bit_cast<std::uint32_t>(one.uv[k].u)},
                                {std::bit_cast<std::uint32_t>(one.uv[k].v)});
  };
  const spec::bake::BaseTriangle<Q> base{vertex(0), vertex(1), vertex(2)};
  const spec::bake::Mask<Q> mask{spec::bake::fraction<Q>(one.cutoff.numerator, one.cutoff.denominator)};
  return static_cast<std::uint8_t>(spec::bake::micro_state(t, base, bake_level, index, mask));
}

/// Triangles with their exact maps, a state a byte, and the time that these took.
struct Baked {
  std::vector<Textured> cases = {};
  std::vector<baking::AlphaView> views = {};
  std::vector<baking::TriangleBaker> bakers = {};
  std::vector<std::uint8_t> truth = {};
  double rational_ns = 0;

  Baked(Textured (*draw)(Random&), Random random, std::size_t triangles) {
    for (std::size_t k = 0; k < triangles; ++k) cases.push_back(draw(random));
    for (const Textured& one : cases) views.push_back({one.texels.data(), one.width, one.height, one.width});
    for (std::size_t k = 0; k < triangles; ++k) bakers.emplace_back(views[k], cases[k].cutoff);
    rational_ns = once_ns([this] {
                    for (const Textured& one : cases) specify(one);
                  }) /
                  static_cast<double>(triangles * states_a_map);
  }

  void specify(const Textured& one) {
    const spec::bake::Texture t{one.width, one.height, one.texels, spec::bake::Wrap::repeat,
                                spec::bake::Wrap::repeat};
    for (std::uint32_t k = 0; k < states_a_map; ++k) {
      try {
        truth.push_back(exact_state<spec::Rational128>(t, one, k));
      } catch (const std::overflow_error&) {
        truth.push_back(exact_state<spec::Rational>(t, one, k));
      }
    }
  }
};

/// out: states_a_map bytes.
using BakeOne = std::function<void(const Baked&, std::size_t triangle, std::span<std::uint8_t> out)>;

std::uint64_t wrong_states(const Baked& baked, const BakeOne& bake) {
  std::uint64_t wrong = 0;
  std::vector<std::uint8_t> states(states_a_map);
  for (std::size_t t = 0; t < baked.cases.size(); ++t) {
    bake(baked, t, states);
    for (std::size_t k = 0; k < states_a_map; ++k)
      wrong += states[k] != baked.truth[t * states_a_map + k] ? 1 : 0;
  }
  return wrong;
}

/// A map of ours, packed in the first bytes of `out`.
baking::BakeCounts bake_ours(const Baked& baked, std::size_t triangle, std::span<std::uint8_t> out) {
  return baked.bakers[triangle].bake(baked.cases[triangle].uv, bake_level, out.first(states_a_map / 4));
}

void bake_ours_unpacked(const Baked& baked, std::size_t triangle, std::span<std::uint8_t> out) {
  bake_ours(baked, triangle, out);
  for (std::size_t k = states_a_map; k-- > 0;) out[k] = out[k / 4] >> 2 * (k % 4) & 3;
}

double share_of_whole_numbers(const Baked& baked) {
  std::vector<std::uint8_t> map(states_a_map);
  std::uint64_t exact = 0;
  for (std::size_t t = 0; t < baked.cases.size(); ++t) exact += bake_ours(baked, t, map).exact;
  return static_cast<double>(exact) / static_cast<double>(baked.truth.size());
}

BakeOne obvious(BakeInto into) {
  return [into](const Baked& baked, std::size_t triangle, std::span<std::uint8_t> out) {
    const Textured& one = baked.cases[triangle];
    into({baked.views[triangle], static_cast<double>(one.cutoff.numerator) / one.cutoff.denominator}, one.uv,
         bake_level, out);
  };
}

/// Judges `judge`, and times `timed`, which bakes the same without unpacking.
StiffFigure baker_figure(const Baked& stiff, const Baked& ordinary, const BakeOne& judge,
                         const BakeOne& timed, std::size_t rounds) {
  StiffFigure figure{.cases = stiff.truth.size(),
                     .wrong = wrong_states(stiff, judge),
                     .ordinary_wrong = wrong_states(ordinary, judge)};
  std::vector<std::uint8_t> states(states_a_map);
  add_times(figure, stiff.truth.size(), ordinary.truth.size(), rounds, [&](bool is_stiff) {
    const Baked& baked = is_stiff ? stiff : ordinary;
    for (std::size_t t = 0; t < baked.cases.size(); ++t) timed(baked, t, states);
  });
  return figure;
}

}  // namespace

void add_triangles(const StiffBenchOptions& o, std::vector<StiffFigure>& figures) {
  const std::size_t triangles = std::max(fewest_triangles, o.samples / samples_a_triangle);
  const auto begins = [&](const char* kind) {
    if (o.progress) o.progress(kind);
  };
  begins("ordinary triangles");
  const Baked usual(ordinary_triangle, stream(o.seed, 1), triangles);
  struct Kind {
    const char* name;
    Textured (*draw)(Random&);
  };
  const std::pair<const char*, BakeInto> obvious_ones[] = {{"centre sample", bake_centre},
                                                           {"corner samples", bake_corners},
                                                           {"16 samples", bake_sixteen},
                                                           {"rasterised, binary64", bake_rasterised}};
  std::uint32_t number = 2;
  for (const Kind& kind : {Kind{"slivers", sliver}, Kind{"cutoffs", meets_cutoff}, Kind{"repeats", repeated},
                           Kind{"subnormal UVs", subnormal_uv}}) {
    begins(kind.name);
    const Baked stiff(kind.draw, stream(o.seed, number++), triangles);
    const auto add = [&](const char* method, StiffFigure figure) {
      figure.kind = kind.name;
      figure.method = method;
      figures.push_back(std::move(figure));
    };
    for (const auto& [method, into] : obvious_ones)
      add(method, baker_figure(stiff, usual, obvious(into), obvious(into), o.rounds));
    StiffFigure ours = baker_figure(stiff, usual, bake_ours_unpacked, bake_ours, o.rounds);
    ours.is_ours = true;
    ours.exact = share_of_whole_numbers(stiff);
    add("ours", ours);
    add("rational", {.cases = stiff.truth.size(),
                     .ns = stiff.rational_ns,
                     .ratio = stiff.rational_ns / usual.rational_ns});
  }
}

}  // namespace mmverify::bench::stiff
