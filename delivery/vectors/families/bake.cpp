// Baking: a texture, texture coordinates, the exact states, and the distance of each from another state.
#include <algorithm>
#include <array>
#include <functional>
#include <stdexcept>

#include "delivery/vectors/binary32.hpp"
#include "delivery/vectors/builder.hpp"
#include "delivery/vectors/families/all.hpp"
#include "spec/bake/state.hpp"

namespace mmverify::vectors::bake {
namespace {

using namespace spec::bake;
using spec::Level;

/// The inputs of one bake.
struct Case {
  const char* about;
  Texture texture;
  std::array<float, 6> uv;  ///< u and v of the three vertices
  Level level;
  std::uint32_t cutoff;  ///< the bits of a binary32 number
  bool blend = false;
};

/// The exact states of one micro-triangle, and their distances from another state.
struct ExactStates {
  spec::micromap::State closed, open, above;
  Rational gap;   ///< least change of all alpha that gives another of T, O and unknown
  Rational side;  ///< distance of alpha at the centroid from the line between UT and UO
};

/// A fraction of narrow integers as one of integers of any size.
template <class Q>
Rational widened(const Q& q) {
  return Rational(Integer(q.numerator()), Integer(q.denominator()));
}

/// The bounds on alpha: opaque at opaque_from or above, transparent at transparent_to or below; unknown is UO
/// from rather_opaque_from on.
template <class Q>
struct Lines {
  Q opaque_from, transparent_to, rather_opaque_from;
};

template <class Q, class Mode, class Above>
ExactStates found(const Case& c, const Mode& mode, const Above& above, const Lines<Q>& lines,
                  std::uint32_t index) {
  using spec::micromap::State;
  BaseTriangle<Q> uv;
  for (std::size_t k = 0; k < 3; ++k) uv[k] = place<Q>({bits_of(c.uv[2 * k])}, {bits_of(c.uv[2 * k + 1])});
  const std::span<const Texture> one(&c.texture, 1);
  ExactStates f{};
  f.closed = micro_state(one, uv, c.level, index, mode);
  f.open = micro_state(one, uv, c.level, index, mode, Q(0), Contact::open);
  f.above = micro_state(one, uv, c.level, index, above);
  const Polygon<Q> polygon = micro_triangle(uv, c.level, index, c.texture.width, c.texture.height);
  const Range<Q> alpha = range(c.texture, polygon);
  f.gap = widened<Q>(f.closed == State::O   ? alpha.least - lines.opaque_from
                     : f.closed == State::T ? lines.transparent_to - alpha.greatest
                                            : std::min<Q>(lines.opaque_from - alpha.least,
                                                          alpha.greatest - lines.transparent_to));
  const Q off = spec::bake::alpha(c.texture, centroid(polygon)) - lines.rather_opaque_from;
  f.side = widened<Q>(off < 0 ? Q(-off) : off);
  return f;
}

template <class Q>
ExactStates found_in(const Case& c, std::uint32_t index) {
  if (c.blend) return found<Q>(c, Blend<Q>{}, Blend<Q>{}, {Q(1), Q(0), fraction<Q>(1, 2)}, index);
  const Q cutoff = number<Q>(Binary32{c.cutoff});
  return found<Q>(c, Mask<Q>{cutoff}, MaskAbove<Q>{cutoff}, {cutoff, cutoff, cutoff}, index);
}

/// Computes in 128-bit fractions, which are faster and exact, and in big ones if those overflow.
ExactStates found(const Case& c, std::uint32_t index) try {
  return found_in<spec::Rational128>(c, index);
} catch (const std::overflow_error&) {
  return found_in<Rational>(c, index);
}

void add(Builder& out, const Case& c) {
  Bytes closed, open, above;
  std::vector<std::uint32_t> gaps, sides, corners;
  for (std::uint32_t index = 0; index < 1u << 2 * c.level; ++index) {
    const ExactStates f = found(c, index);
    closed.push_back(spec::micromap::code(f.closed));
    open.push_back(spec::micromap::code(f.open));
    above.push_back(spec::micromap::code(f.above));
    gaps.push_back(rounded_down(f.gap));
    sides.push_back(rounded_down(f.side));
  }
  for (const float x : c.uv) corners.push_back(bits_of(x));
  const Texture& t = c.texture;
  out.add({c.about, t.width, t.height, t.alpha, static_cast<std::uint32_t>(t.filter),
           static_cast<std::uint32_t>(t.wrap_x), static_cast<std::uint32_t>(t.wrap_y), t.border,
           c.blend ? 1u : 0u, c.cutoff, c.level, corners, closed, open, above, gaps, sides});
}

Texture made(std::uint32_t width, std::uint32_t height,
             const std::function<unsigned(std::uint32_t, std::uint32_t)>& alpha,
             Filter filter = Filter::bilinear, Wrap wrap = Wrap::clamp_to_edge) {
  Texture t{.width = width, .height = height};
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) t.alpha.push_back(static_cast<std::uint8_t>(alpha(x, y)));
  t.filter = filter;
  t.wrap_x = t.wrap_y = wrap;
  return t;
}

constexpr std::array<float, 6> half_square{0, 0, 1, 0, 0, 1};

const std::uint32_t half = bits_of(0.5f);

unsigned disc(std::uint32_t x, std::uint32_t y) {
  const int dx = 2 * static_cast<int>(x) - 5, dy = 2 * static_cast<int>(y) - 5;
  return static_cast<unsigned>(std::max(0, 255 - 9 * (dx * dx + dy * dy)));
}
unsigned checks(std::uint32_t x, std::uint32_t y) { return (x + y) % 2 == 0 ? 255u : 0u; }
unsigned step(std::uint32_t x, std::uint32_t) { return x == 0 ? 0u : 255u; }
unsigned full(std::uint32_t, std::uint32_t) { return 255u; }

void add_few_texels(Builder& out) {
  const std::uint32_t one = bits_of(1);
  add(out, {"one texel, opaque", made(1, 1, full), half_square, 1, half});
  add(out, {"alpha is the cutoff everywhere: a tie", made(1, 1, full), half_square, 1, one});
  add(out, {"cutoff 0: always opaque", made(2, 2, checks), half_square, 1, 0});
  add(out, {"cutoff above 1: never opaque", made(2, 2, checks), half_square, 1, bits_of(1.5f)});
  add(out, {"one step of 8 bits beside the cutoff",
            made(2, 1, [](std::uint32_t x, std::uint32_t) { return 127 + x; }), half_square, 2, half});
  add(out, {"a contour along grid lines: ties", made(2, 1, step), half_square, 2, half});
  add(out, {"the same, turned: u and v exchanged",
            made(1, 2, [](std::uint32_t x, std::uint32_t y) { return step(y, x); }), half_square, 2, half});
  add(out, {"texels' edges along grid lines: contact of area 0", made(2, 2, checks, Filter::nearest),
            half_square, 2, half});
  add(out, {"nearest, texels' edges across", made(3, 3, checks, Filter::nearest), half_square, 2, half});
  add(out, {"a saddle: extremes on edges, not in corners",
            made(2, 2, checks),
            {0.25f, 0.25f, 0.75f, 0.3125f, 0.375f, 0.8125f},
            2,
            half});
  add(out, {"an opaque texel that no corner meets",
            made(5, 5, [](std::uint32_t x, std::uint32_t y) { return x == 2 && y == 1 ? 255u : 0u; }),
            {0, 0, 0.9375f, 0.0625f, 0.03125f, 0.96875f},
            1,
            half});
}

void add_discs_and_blends(Builder& out) {
  add(out, {"a disc", made(6, 6, disc), half_square, 3, half});
  add(out, {"a disc, another cutoff",
            made(6, 6, disc),
            {0.9f, 0.95f, 0.05f, 0.8f, 0.7f, 0.1f},
            3,
            bits_of(0.25f)});
  add(out, {"a disc, nearest",
            made(6, 6, disc, Filter::nearest),
            {0.03125f, 0.0625f, 0.96875f, 0.125f, 0.25f, 0.9375f},
            3,
            half});
  add(out, {"BLEND: opaque from 1, transparent up to 0", made(6, 6, disc), half_square, 2, half, true});
  add(out, {"BLEND, nearest", made(3, 3, checks, Filter::nearest), half_square, 2, half, true});
}

/// Coordinates beyond the texture, by each addressing.
void add_addressings(Builder& out) {
  constexpr std::array<float, 6> beyond{-0.75f, -0.5f, 1.625f, -0.25f, -0.375f, 1.75f};
  for (const auto& [about, wrap] : {std::pair{"beyond the texture: repeat", Wrap::repeat},
                                    {"beyond the texture: mirrored repeat", Wrap::mirrored_repeat},
                                    {"beyond the texture: clamp to edge", Wrap::clamp_to_edge},
                                    {"beyond the texture: border", Wrap::clamp_to_border},
                                    {"beyond the texture: mirror once", Wrap::mirror_once}}) {
    Case c{about,
           made(
               3, 2, [](std::uint32_t x, std::uint32_t y) { return 40 * x + 120 * y + 30; }, Filter::bilinear,
               wrap),
           beyond, 2, half};
    c.texture.border = 255;
    add(out, c);
  }
  Case apart{"another addressing along each axis", made(3, 3, disc), beyond, 2, bits_of(0.375f)};
  apart.texture.wrap_x = Wrap::mirrored_repeat;
  apart.texture.wrap_y = Wrap::repeat;
  add(out, apart);
}

void add_shapes_and_any_texels(Builder& out) {
  add(out, {"clockwise in the texture", made(6, 6, disc), {0, 1, 1, 0, 0, 0}, 2, half});
  add(out,
      {"coordinates on a line", made(4, 4, checks), {0.125f, 0.25f, 0.875f, 0.25f, 0.5f, 0.25f}, 2, half});
  add(out, {"coordinates in a point",
            made(4, 4, checks),
            {0.375f, 0.375f, 0.375f, 0.375f, 0.375f, 0.375f},
            1,
            half});
  add(out, {"level 0: the whole triangle", made(4, 4, disc), half_square, 0, half});
  Mixed mixed(1);
  const auto any = [&mixed](std::uint32_t, std::uint32_t) { return mixed.bits(8); };
  add(out, {"any texels", made(5, 4, any), {0.1f, 0.2f, 0.95f, 0.3f, 0.4f, 0.85f}, 3, half});
  add(out, {"any texels, nearest",
            made(5, 4, any, Filter::nearest),
            {0.1f, 0.2f, 0.95f, 0.3f, 0.4f, 0.85f},
            3,
            half});
}

}  // namespace

Family family() {
  Builder out("bake", 1,
              "exact states of micro-triangles from an alpha texture; alpha = byte / 255, no mip levels");
  out.table(
      "bakes", "A texture, a triangle, its map.",
      {{"about", Kind::about, "why the vector is there"},
       {"width", Kind::number, "in texels"},
       {"height", Kind::number, "in texels"},
       {"texels", Kind::bytes, "alpha, rows from the top (v = 0)"},
       {"filter", Kind::name, "of the sampler", {"bilinear", "nearest"}},
       {"wrap_u",
        Kind::name,
        "addressing along u",
        {"repeat", "mirrored-repeat", "clamp", "border", "mirror-once"}},
       {"wrap_v",
        Kind::name,
        "addressing along v",
        {"repeat", "mirrored-repeat", "clamp", "border", "mirror-once"}},
       {"border", Kind::number, "alpha of the border, a byte"},
       {"mode",
        Kind::name,
        "mask: against the cutoff; blend: opaque at 1, transparent at 0",
        {"mask", "blend"}},
       {"cutoff", Kind::binary32, "of mode mask"},
       {"level", Kind::number, "n; 4^n micro-triangles"},
       {"uv", Kind::binary32s, "u and v of the first, second and third vertex"},
       {"closed", Kind::digits, "states: opaque from the cutoff on, edges and corners count"},
       {"open", Kind::digits, "states: what is met in an area of 0 does not count"},
       {"above", Kind::digits, "states: opaque above the cutoff alone, edges and corners count"},
       {"gaps", Kind::binary32s, "of closed: by how much alpha may be off before T, O or unknown changes"},
       {"sides", Kind::binary32s, "by how much alpha at the centroid is off the line between UT and UO"}});
  add_few_texels(out);
  add_discs_and_blends(out);
  add_addressings(out);
  add_shapes_and_any_texels(out);
  return out.take();
}

}  // namespace mmverify::vectors::bake
