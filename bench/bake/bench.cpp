#include "bench/bake/bench.hpp"

#include <algorithm>
#include <bit>
#include <random>
#include <stdexcept>

#include "bench/bake/obvious.hpp"
#include "bench/textures/leaf_texture.hpp"
#include "bench/timing.hpp"
#include "impl/bake/triangles.hpp"
#include "spec/bake/state.hpp"
#include "spec/bake/whole/state.hpp"

namespace mmverify::bench {
namespace {

namespace fast = impl::bake;
using fast::AlphaView;
using fast::BaseTriangle;
using States = std::vector<std::uint8_t>;

constexpr fast::Cutoff cutoff{1, 2};
constexpr std::uint32_t level_of_sizes = 6;
constexpr std::size_t compared_a_map = 24;
const BaseTriangle halves[] = {{{{0, 0}, {1, 0}, {0, 1}}}, {{{1, 1}, {0, 1}, {1, 0}}}};

AlphaView view(const AlphaTexture& t) {
  const auto width = static_cast<std::uint32_t>(t.width);
  return {t.alpha.data(), width, static_cast<std::uint32_t>(t.height), width};
}

bool unknown(std::uint8_t state) { return state >= 2; }

States unpacked(const std::vector<std::uint8_t>& map, std::uint32_t level) {
  States states(std::size_t{1} << 2 * level);
  for (std::size_t k = 0; k < states.size(); ++k) states[k] = map[k / 4] >> 2 * (k % 4) & 3;
  return states;
}

/// A map of ours, and the counts of its bake.
struct Ours {
  std::vector<std::uint8_t> map;
  fast::BakeCounts counts;
};
Ours ours(const fast::TriangleBaker& baker, const BaseTriangle& uv, std::uint32_t level) {
  Ours o{std::vector<std::uint8_t>(((std::size_t{1} << 2 * level) + 3) / 4), {}};
  o.counts = baker.bake(uv, level, o.map);
  return o;
}

template <class Q>
std::uint8_t specified(const spec::bake::Texture& t, const BaseTriangle& uv, std::uint32_t level,
                       std::uint32_t index) {
  const auto vertex = [&](std::size_t k) {
    return spec::bake::place<Q>({std::bit_cast<std::uint32_t>(uv[k].u)},
                                {std::bit_cast<std::uint32_t>(uv[k].v)});
  };
  const spec::bake::BaseTriangle<Q> base{vertex(0), vertex(1), vertex(2)};
  const spec::bake::Mask<Q> mask{spec::bake::fraction<Q>(cutoff.numerator, cutoff.denominator)};
  return static_cast<std::uint8_t>(spec::bake::micro_state(t, base, level, index, mask));
}

/// The state in whole numbers; none where these find none.
std::optional<std::uint8_t> in_whole_numbers(const spec::bake::whole::WholeTexture& t, const BaseTriangle& uv,
                                             std::uint32_t level, std::uint32_t index) {
  using spec::bake::State;
  const auto bits = [](float x) { return spec::bake::Binary32{std::bit_cast<std::uint32_t>(x)}; };
  spec::bake::whole::Place place{{}, level, index};
  for (std::size_t k = 0; k < 3; ++k) place.uv[k] = {bits(uv[k].u), bits(uv[k].v)};
  const auto state = spec::bake::whole::state(t, place);
  if (!state || *state != State::C)
    return state ? std::optional<std::uint8_t>(*state == State::O ? 1 : 0) : std::nullopt;
  const auto leans = spec::bake::whole::leans(t, place);
  return leans ? std::optional<std::uint8_t>(*leans ? 3 : 2) : std::nullopt;
}

/// Random micro-triangles to compare, half of them unknown if there are enough: those are next to a change of
/// state.
std::vector<std::uint32_t> chosen(const States& states, std::mt19937_64& random) {
  std::vector<std::uint32_t> at;
  for (std::size_t tries = 0; at.size() < compared_a_map && tries < 4096; ++tries) {
    const auto k = static_cast<std::uint32_t>(random() % states.size());
    if (at.size() < compared_a_map / 2 || unknown(states[k]) || tries > 2048) at.push_back(k);
  }
  return at;
}

/// A texture for the specification, in rationals and in whole numbers.
struct Specified {
  const std::string& file;
  const spec::bake::Texture& rational;
  const spec::bake::whole::WholeTexture& whole;
};

/// Times the specification in both kinds of numbers on some micro-triangles, and compares their states with ours; returns
/// how many.
std::uint64_t compare(const Specified& t, const BaseTriangle& uv, const States& ours,
                      const std::vector<std::uint32_t>& at, std::size_t rounds, BakeLevel& result) {
  BakeFigure& rational = result.by[static_cast<std::size_t>(Baker::rational)];
  std::vector<std::optional<std::uint8_t>> in_whole(at.size());
  result.whole_ns += median_ns(rounds, [&] {
    for (std::size_t k = 0; k < at.size(); ++k)
      in_whole[k] = in_whole_numbers(t.whole, uv, result.level, at[k]);
  });
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double start = thread_ns();
    const std::uint8_t state = specified<spec::Rational128>(t.rational, uv, result.level, at[k]);
    const double ns = thread_ns() - start;
    rational.add({ns, ns, ns});
    ++rational.micro_triangles;
    if (state != ours[at[k]] || in_whole[k] != state)
      throw std::runtime_error(std::string("bake bench: ") +
                               (state != ours[at[k]] ? "ours is" : "whole numbers are") + " wrong on " +
                               t.file + ", level " + std::to_string(result.level) + ", micro-triangle " +
                               std::to_string(at[k]));
  }
  return at.size();
}

void measure_level(const std::vector<AlphaTexture>& textures, std::size_t rounds, std::mt19937_64& random,
                   BakeLevel& result, std::uint64_t& compared) {
  const std::uint32_t level = result.level;
  std::uint64_t leaves = 0, exact = 0, mixed = 0, all = 0;
  constexpr std::pair<Baker, BakeInto> obvious[] = {{Baker::centre, bake_centre},
                                                    {Baker::corners, bake_corners},
                                                    {Baker::sixteen_samples, bake_sixteen},
                                                    {Baker::rasterised, bake_rasterised}};
  const auto figure = [&](Baker b) -> BakeFigure& { return result.by[static_cast<std::size_t>(b)]; };
  for (const AlphaTexture& texture : textures) {
    const AlphaView v = view(texture);
    const fast::TriangleBaker baker(v, cutoff);
    const spec::bake::Texture specification{v.width, v.height, texture.alpha, spec::bake::Wrap::repeat,
                                            spec::bake::Wrap::repeat};
    const spec::bake::whole::WholeTexture whole(
        specification, spec::bake::Mask<spec::Rational>{{cutoff.numerator, cutoff.denominator}});
    for (const BaseTriangle& uv : halves) {
      Ours o;
      figure(Baker::ours).add(rounds_ns(rounds, [&] { o = ours(baker, uv, level); }));
      const States truth = unpacked(o.map, level);
      figure(Baker::ours).micro_triangles += truth.size();
      leaves += o.counts.leaves;
      exact += o.counts.exact;
      all += truth.size();
      mixed += static_cast<std::uint64_t>(std::count_if(truth.begin(), truth.end(), unknown));
      compared +=
          compare({texture.file, specification, whole}, uv, truth, chosen(truth, random), rounds, result);
      States states(truth.size());
      for (const auto& [which, into] : obvious) {
        BakeFigure& f = figure(which);
        // The pass is long enough to be timed once.
        f.add(rounds_ns(1, [&, into = into] { into({v, 0.5}, uv, level, states); }));
        f.micro_triangles += states.size();
        for (std::size_t k = 0; k < states.size(); ++k) {
          f.wrong += !unknown(states[k]) && states[k] != truth[k] ? 1 : 0;
          f.needless += unknown(states[k]) && !unknown(truth[k]) ? 1 : 0;
        }
      }
    }
  }
  result.whole_ns /=
      static_cast<double>(std::max<std::uint64_t>(1, result.of(Baker::rational).micro_triangles));
  for (BakeFigure& f : result.by)
    for (double* const ns : {&f.ns, &f.least_ns, &f.most_ns})
      *ns /= static_cast<double>(std::max<std::uint64_t>(1, f.micro_triangles));
  result.unknown = static_cast<double>(mixed) / static_cast<double>(all);
  result.exact = leaves == 0 ? 0 : static_cast<double>(exact) / static_cast<double>(leaves);
}

BakeSize size_of(int size, const BakeBenchOptions& options) {
  BakeSize result{size};
  const std::size_t maps = std::min<std::size_t>(options.maps, 3),
                    count = std::size_t{1} << 2 * level_of_sizes;
  States states(count);
  for (std::size_t k = 0; k < maps; ++k) {
    const AlphaTexture texture = leaf_texture(options.seed + k, size);
    const AlphaView v = view(texture);
    result.ready_ms += median_ns(options.rounds, [&] { const fast::TriangleBaker made(v, cutoff); }) / 1e6;
    const fast::TriangleBaker baker(v, cutoff);
    for (const BaseTriangle& uv : halves) {
      result.ns += median_ns(options.rounds, [&] { ours(baker, uv, level_of_sizes); });
      result.ns_rasterised += median_ns(options.rounds, [&] {
        bake_rasterised({v, 0.5}, uv, level_of_sizes, states);
      });
    }
  }
  const double micro_triangles = static_cast<double>(2 * maps * count);
  result.ns /= micro_triangles;
  result.ns_rasterised /= micro_triangles;
  result.ready_ms /= static_cast<double>(maps);
  return result;
}

BakeMargin with_margin(float margin, const std::vector<AlphaTexture>& textures, std::size_t rounds) {
  BakeMargin result{margin};
  std::uint64_t mixed = 0, all = 0;
  for (const AlphaTexture& texture : textures) {
    const fast::Texels mip = view(texture);
    fast::Sampling sampling;
    sampling.margin = margin;
    const fast::TriangleBaker baker(std::span(&mip, 1), cutoff, sampling);
    for (const BaseTriangle& uv : halves) {
      Ours o;
      result.ns += median_ns(rounds, [&] { o = ours(baker, uv, level_of_sizes); });
      const States states = unpacked(o.map, level_of_sizes);
      mixed += static_cast<std::uint64_t>(std::count_if(states.begin(), states.end(), unknown));
      all += states.size();
    }
  }
  result.ns /= static_cast<double>(all);
  result.unknown = static_cast<double>(mixed) / static_cast<double>(all);
  return result;
}

double per_million(std::uint64_t part, std::uint64_t all) {
  return all == 0 ? 0 : 1e6 * static_cast<double>(part) / static_cast<double>(all);
}

}  // namespace

const char* to_string(Baker baker) {
  constexpr const char* names[] = {"centre sample", "corner samples", "16 samples",
                                   "binary64",      "ours, exact",    "exact rational"};
  return names[static_cast<std::size_t>(baker)];
}

double BakeFigure::wrong_per_million() const { return per_million(wrong, micro_triangles); }
double BakeFigure::needless_per_million() const { return per_million(needless, micro_triangles); }

BakeFigures bake_figures(const BakeBenchOptions& options) {
  if (options.maps == 0 || options.rounds == 0 || options.first > options.last ||
      options.last > fast::max_bake_level)
    throw std::invalid_argument("bake bench: a texture and a round at least, levels up to 12");
  const auto begins = [&](const std::string& what) {
    if (options.progress) options.progress(what);
  };
  BakeFigures figures;
  std::vector<AlphaTexture> textures;
  begins(options.textures.empty() ? "generating textures" : "textures of " + options.textures);
  if (options.textures.empty())
    for (std::size_t k = 0; k < options.maps; ++k) textures.push_back(leaf_texture(options.seed + k));
  else
    textures = alpha_textures(options.textures);
  for (const AlphaTexture& t : textures) figures.textures.push_back(t.file);
  std::mt19937_64 random(options.seed);
  for (std::uint32_t level = options.first; level <= options.last; ++level) {
    begins("level " + std::to_string(level));
    figures.levels.push_back({level});
    measure_level(textures, options.rounds, random, figures.levels.back(), figures.compared);
  }
  for (int size = 64; size <= options.largest; size *= 2) {
    begins("textures of " + std::to_string(size) + " texels");
    figures.sizes.push_back(size_of(size, options));
  }
  // 1/512 is half a step of a filter's 8-bit weights.
  for (const float margin : {0.0f, 1.0f / 512, 1.0f / 64, 1.0f / 16, 0.25f, 1.0f}) {
    begins("a margin of " + std::to_string(margin) + " texels");
    figures.margins.push_back(with_margin(margin, textures, options.rounds));
  }
  begins("updates");
  figures.updates = bake_updates(textures, options.seed, options.rounds);
  return figures;
}

}  // namespace mmverify::bench
