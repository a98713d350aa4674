// Laws of large textures: points refute states, since the specification cannot visit all texels.
#include "proofs/bake/cases/lone_texel.hpp"
#include "proofs/bake/domains/threshold.hpp"
#include "proofs/bake/law_parts.hpp"
#include "proofs/bake/laws.hpp"
#include "proofs/bake/mutants/states.hpp"
#include "spec/index/index.hpp"

namespace mmverify::proofs::bake {
namespace {

constexpr std::uint32_t least_side = 256;
/// A bound of the rounding errors in binary64, for alpha and for texels.
constexpr double rounding = 1e-6;
/// The highest level at which all micro-triangles are always judged.  Above it one of 61 is judged, unless one is
/// known to hold the lone texel.
constexpr Level all_judged = 9;

/// A point, in texels.
struct TexelPlace {
  double x, y;
};

/// A place in thirds of steps of 1/2^n along the triangle's two edges.
struct Steps {
  std::uint32_t u = 0, v = 0;
  friend bool operator==(const Steps&, const Steps&) = default;
};
/// A micro-triangle's three corners, and its centroid last.
std::array<Steps, 4> points_of(std::uint32_t index, Level n) {
  std::array<Steps, 4> points{};
  std::size_t k = 0;
  for (const spec::index::Vertex& corner : spec::index::corners(index, n)) {
    points[k++] = {3 * corner.i, 3 * corner.j};
    points[3].u += corner.i;
    points[3].v += corner.j;
  }
  return points;
}

/// The texture and the triangle in binary64.
class LonePlane {
 public:
  LonePlane(const Case& one, Level n)
      : one_(one),
        texel_(lone_texel(one.drawn)),
        all_(value_of(one.texel, texel_.all)),
        lone_(value_of(one.texel, texel_.lone)),
        side_(std::ldexp(1.0, static_cast<int>(n))),
        origin_(vertex(0)),
        e_(edge(1)),
        f_(edge(2)) {}

  TexelPlace at(const Steps& p) const {
    const double b = p.u / (3 * side_), c = p.v / (3 * side_);
    return {origin_.x + b * e_.x + c * f_.x, origin_.y + b * e_.y + c * f_.y};
  }

  /// Alpha at a point; nothing if a step within rounding would give another value.
  std::optional<double> alpha(const TexelPlace& p) const {
    const auto x = weight(p.x, one_.width, one_.wrap_u, texel_.i),
               y = weight(p.y, one_.height, one_.wrap_v, texel_.j);
    if (!x || !y) return std::nullopt;
    return all_ + (lone_ - all_) * *x * *y;
  }

  /// Whether a state contradicts this alpha somewhere in its micro-triangle.
  bool denies(State got, double alpha) const {
    const double cutoff = static_cast<double>(one_.cutoff.numerator) / one_.cutoff.denominator,
                 leeway = double{one_.rules.slack} + rounding;
    if (got == State::O) return alpha < (one_.blend ? 1 : cutoff) - leeway;
    return got == State::T && alpha > (one_.blend ? 0 : cutoff) + leeway;
  }

  /// The centroid of the micro-triangle that holds the lone texel's centre well inside; nothing if none does.
  std::optional<Steps> lone_steps() const {
    if (texel_.i >= one_.width || texel_.j >= one_.height) return std::nullopt;
    const TexelPlace centre = lone_centre();
    const double x = centre.x - origin_.x, y = centre.y - origin_.y, area = e_.x * f_.y - e_.y * f_.x;
    if (area == 0) return std::nullopt;
    const double b = (x * f_.y - y * f_.x) / area * side_, c = (e_.x * y - e_.y * x) / area * side_,
                 u = std::floor(b), v = std::floor(c), in_square = b - u + c - v;
    const double off = std::min({b - u, u + 1 - b, c - v, v + 1 - c, std::fabs(in_square - 1)});
    if (off < rounding || b < 0 || c < 0 || b + c > side_) return std::nullopt;
    const std::uint32_t half = in_square > 1 ? 2 : 1;
    return Steps{3 * static_cast<std::uint32_t>(u) + half, 3 * static_cast<std::uint32_t>(v) + half};
  }
  TexelPlace lone_centre() const { return {texel_.i + 0.5, texel_.j + 0.5}; }

 private:
  TexelPlace vertex(std::size_t k) const {
    return {double{one_.uv[2 * k]} * one_.width, double{one_.uv[2 * k + 1]} * one_.height};
  }
  TexelPlace edge(std::size_t k) const {
    const TexelPlace p = vertex(k);
    return {p.x - origin_.x, p.y - origin_.y};
  }
  /// The weight of the lone texel's column, or row, in a sample at x.
  std::optional<double> weight(double x, std::uint32_t size, Wrap wrap, std::uint32_t texel) const {
    const bool bilinear = one_.filter == Filter::bilinear;
    const double from = bilinear ? x - 0.5 : x, first = std::floor(from), second = from - first;
    if (!bilinear && (second < rounding || second > 1 - rounding)) return std::nullopt;
    const auto is = [&](double column) {
      return spec::bake::wrapped(wrap, static_cast<std::int64_t>(column), size) == texel ? 1.0 : 0.0;
    };
    return bilinear ? is(first) * (1 - second) + is(first + 1) * second : is(first);
  }

  const Case& one_;
  LoneTexel texel_;
  double all_, lone_, side_;
  TexelPlace origin_, e_, f_;
};

Finding denied(std::uint32_t index, State got, const TexelPlace& at, double alpha) {
  return wrong([=] {
    return Words{fmt::format("micro-triangle {} not {}: alpha is {:g} at texel ({:.4f}, {:.4f})", index,
                             name_of(got), alpha, at.x, at.y),
                 std::string(name_of(got))};
  });
}

Finding contradicts_no_sample(const BakeSubject& s, const Case& one, Level n) {
  if (!one.drawn.starts_with(lone_begins))
    throw BadCase("texels=TYPE:WIDTHxHEIGHT:lone-ALL-TEXEL-COLUMN-ROW is what this law is about");
  if (one.mips != 1 || one.factor != 1 || one.vertex_factor != 1 || one.margin != 0)
    throw BadCase("one mip, without factors and margin: textures with a lone texel have no more");
  const auto baked = s.functions.bake(one, n, Format::four_state);
  if (!baked) return unsupported();
  const LonePlane plane(one, n);
  const auto holding = plane.lone_steps();
  const std::uint32_t step = n <= all_judged || holding ? 1 : 61;
  for (std::uint32_t k = 0; k < baked->states.size(); k += step) {
    const State got = baked->states[k];
    if (spec::micromap::unknown(got)) continue;
    const std::array<Steps, 4> points = points_of(k, n);
    for (const Steps& point : points) {
      const TexelPlace at = plane.at(point);
      const auto alpha = plane.alpha(at);
      if (alpha && plane.denies(got, *alpha)) return denied(k, got, at, *alpha);
    }
    if (holding == points.back()) {
      const TexelPlace centre = plane.lone_centre();
      const auto alpha = plane.alpha(centre);
      if (alpha && plane.denies(got, *alpha)) return denied(k, got, centre, *alpha);
    }
  }
  return {hash_of(baked->states)};
}

std::uint64_t cases_at(Level n, Tier tier) {
  constexpr std::uint64_t shapes = 13, all = shapes + 1;  // the last shape takes seconds
  if (tier == Tier::fast) return n == 3 ? all : n <= 6 ? shapes : n <= 9 ? 2 : 1;
  return shapes * (n <= 6 ? 100 : n <= 9 ? 10 : 1);
}

void transparent_from_level_5_on(const Case& one, Level n, std::vector<State>& states) {
  if (one.height >= 1024 && n >= 5)
    for (State& state : states)
      if (state == State::UO) state = State::T;
}

}  // namespace

Law large_law() {
  Law law{.id = "bake.conservative_on_large",
          .says =
              "of a texture of one alpha, but for one texel at most, no micro-triangle is O or T against "
              "what is sampled at a corner, its centroid, or the one texel's centre in it",
          .source = "VK_KHR_opacity_micromap, opacity states; glTF 2.0, Alpha Coverage; spec/bake/state.hpp",
          .method = Method::sample,
          .subjects = {"bake"},
          .tiers = {.fast = {0, 12}, .long_run = {0, 12}, .seconds = 0.5},
          .domain =
              "large ones: 13 shapes from 2^16 to 2^20 texels, among them 16384x4, and at level 3 one "
              "of more than 2^24; 8 and 16 bits and binary32, both filters, all addressing; the border "
              "is as the other texels; half of the texture, all of it, or a triangle somewhere on it; "
              "of sides of 4,096 texels and more also half a million repeats away, clamped",
          .mutants = {spoiled("an unknown of 1,024 rows and more is transparent from level 5 on", "bake",
                              {5, 5}, transparent_from_level_5_on)}};
  Cases cases;
  cases.count = [](Level n, const Run& run) { return cases_at(n, run.tier); };
  cases.number = case_with_lone_texel;
  cases.chunk = 4;
  return on_cases(
      std::move(law), cases,
      [](const BakeSubject& s, const Case& one, Level n, const std::optional<std::uint64_t>&) {
        return contradicts_no_sample(s, one, n);
      },
      {},
      [](const BakeSubject& s, Level) -> std::optional<std::string> {
        const std::uint32_t most = s.functions.support.max_side;
        if (most >= least_side) return std::nullopt;
        return fmt::format("it declares sides up to {}: no texture of 65,536 texels", most);
      });
}

}  // namespace mmverify::proofs::bake
