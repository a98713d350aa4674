#include <cmath>

#include "proofs/bake/diagnosis/diagnosis.hpp"
#include "proofs/bake/truth/exact_texture.hpp"
#include "proofs/drawing/canvas.hpp"
#include "proofs/points/narrow.hpp"
#include "proofs/points/point.hpp"

namespace mmverify::proofs::bake {
namespace {

namespace bake = spec::bake;
using drawing::blue, drawing::Canvas, drawing::grey, drawing::ink, drawing::Pixel, drawing::vermilion;
using points::nearest;
using Polygon = bake::Polygon<Rational>;

constexpr double left = 40, top = 96, size = 600;
constexpr int samples = 120;     // opaque places drawn along a side
constexpr int most_texels = 12;  // the most texels along a side that are drawn with their numbers

const char* full_name(State s) {
  constexpr const char* names[] = {"transparent (T)", "opaque (O)", "unknown-transparent (UT)",
                                   "unknown-opaque (UO)"};
  return names[static_cast<std::size_t>(s)];
}

/// A square of the texture, which maps texels to pixels.
struct View {
  TexturePoint origin;
  Rational span;

  /// The origin is subtracted before rounding, so that places far from texel 0 stay exact.
  Pixel operator()(const TexturePoint& p) const {
    return {left + size * nearest((p.x - origin.x) / span), top + size * nearest((p.y - origin.y) / span)};
  }
  std::vector<Pixel> operator()(const Polygon& polygon) const {
    std::vector<Pixel> pixels;
    for (const TexturePoint& p : polygon) pixels.push_back((*this)(p));
    return pixels;
  }
};

/// A view of the polygon with some room around it.  A small polygon is shown with up to 2.5 texels, but at most with
/// 8 times its size.
View around(const Polygon& polygon) {
  const auto [left_most, right_most] = std::minmax_element(
      polygon.begin(), polygon.end(), [](const TexturePoint& p, const TexturePoint& q) { return p.x < q.x; });
  const auto [highest, lowest] = std::minmax_element(
      polygon.begin(), polygon.end(), [](const TexturePoint& p, const TexturePoint& q) { return p.y < q.y; });
  const Rational wide = right_most->x - left_most->x, high = lowest->y - highest->y;
  Rational span = std::max(wide, high);
  const Rational some_texels(5, 2);
  span = span == 0 ? Rational(2)
                   : std::max(Rational(span * Rational(8, 5)), std::min(some_texels, Rational(span * 8)));
  return {{left_most->x + wide / 2 - span / 2, highest->y + high / 2 - span / 2}, span};
}

template <class Stored>
std::string stored_text(const bake::TextureOf<Stored>& t, std::int64_t i, std::int64_t j) {
  const auto x = bake::wrapped(t.wrap_x, i, t.width), y = bake::wrapped(t.wrap_y, j, t.height);
  const Stored stored = x && y ? t.alpha[*x + std::size_t{*y} * t.width] : t.border;
  if constexpr (std::is_same_v<Stored, bake::Binary32>)
    return fmt::format("{:.3g}", std::bit_cast<float>(stored.bits));
  else
    return fmt::format("{}", stored);
}

/// The opaque part, drawn row by row in small squares.
template <class Texture>
void draw_opaque(Canvas& canvas, const View& view, const Texture& t, const Case& one) {
  const auto opaque = [&](int column, int row) {
    return in_smallest([&]<class Q>() {
      const auto at = [](const Rational& origin, const Rational& span, int k) {
        const Rational exact = origin + span * bake::fraction<Rational>(2 * k + 1, 2 * samples);
        return Q(typename Q::int_type(exact.numerator()), typename Q::int_type(exact.denominator()));
      };
      const bake::TexturePoint<Q> p{at(view.origin.x, view.span, column), at(view.origin.y, view.span, row)};
      return with_mode<Q>(one, [&](const auto& mode) { return mode.opaque(bake::alpha(t, p)); });
    });
  };
  constexpr double step = size / samples;
  for (int row = 0; row < samples; ++row) {
    int from = -1;
    for (int column = 0; column <= samples; ++column) {
      const bool here = column < samples && opaque(column, row);
      if (here && from < 0) from = column;
      if (here || from < 0) continue;
      const double x = left + from * step, end = left + column * step, y = top + row * step;
      canvas.polygon({{x, y}, {end, y}, {end, y + step}, {x, y + step}}, "#bcd9c4", "none", 0);
      from = -1;
    }
  }
}

/// Lines between texels, and each texel's number at its centre, if few enough texels are in view.
template <class Texture>
void draw_texels(Canvas& canvas, const View& view, const Texture& t) {
  if (view.span > most_texels) return;
  const std::int64_t x0 = bake::floored(view.origin.x), y0 = bake::floored(view.origin.y),
                     x1 = bake::floored(Rational(view.origin.x + view.span)),
                     y1 = bake::floored(Rational(view.origin.y + view.span));
  const auto whole = [](std::int64_t k) { return bake::fraction<Rational>(k, 1); };
  for (std::int64_t i = x0 + 1; i <= x1; ++i) {
    const double x = view({whole(i), view.origin.y}).x;
    canvas.polygon({{x, top}, {x, top + size}}, "none", grey, 1, 1, false);
  }
  for (std::int64_t j = y0 + 1; j <= y1; ++j) {
    const double y = view({view.origin.x, whole(j)}).y;
    canvas.polygon({{left, y}, {left + size, y}}, "none", grey, 1, 1, false);
  }
  for (std::int64_t j = y0; j <= y1; ++j)
    for (std::int64_t i = x0; i <= x1; ++i) {
      const Pixel p = view({bake::Cell<Rational>::along(i), bake::Cell<Rational>::along(j)});
      if (p.x < left + 8 || p.x > left + size - 8 || p.y < top + 8 || p.y > top + size - 8) continue;
      canvas.dot(p, 2, grey, grey);
      canvas.text({p.x + 5, p.y - 5}, stored_text(t, i, j), 12, "#555555");
    }
}

/// White margins over shapes that reach beyond the square.
void mask_margins(Canvas& canvas, double width, double height) {
  const auto cover = [&](double x0, double y0, double x1, double y1) {
    canvas.polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, "#ffffff", "none", 0);
  };
  cover(0, 0, width, top);
  cover(0, top + size, width, height);
  cover(0, 0, left, height);
  cover(left + size, 0, width, height);
  canvas.polygon({{left, top}, {left + size, top}, {left + size, top + size}, {left, top + size}}, "none",
                 ink, 1);
}

std::string where_in(const Extreme& e) {
  const std::string at = fmt::format("({}, {})", text_of(e.at.x), text_of(e.at.y));
  return e.mip == 0 ? at : fmt::format("{} of mip {}", at, e.mip);
}

/// The place in texels of mip 0, which the picture shows.
TexturePoint in_first(const Case& one, const Extreme& e) {
  const auto scale = [&](std::uint32_t size) {
    return bake::fraction<Rational>(size, std::max(1u, size >> e.mip));
  };
  return {e.at.x * scale(one.width), e.at.y * scale(one.height)};
}

}  // namespace

std::string picture(const Case& one, Level n, const std::optional<Offender>& offender) {
  const Polygon base = corners_of(one, 0, 0), polygon = offender ? corners_of(one, n, offender->index) : base;
  const View view = around(polygon);
  const std::string cutoff =
      one.blend ? "1 (BLEND)" : fmt::format("{}/{}", one.cutoff.numerator, one.cutoff.denominator);
  const bool contradicts = offender && !spec::micromap::unknown(offender->said);
  const std::string title =
      offender ? fmt::format("Level {}, micro-triangle {}: {}", n, offender->index, full_name(offender->said))
               : fmt::format("Level {}: every micro-triangle is right", n);
  std::string line;
  if (contradicts)
    line = fmt::format("but alpha is {} at texel {}, and the cutoff is {}.",
                       text_of(contradiction(*offender).alpha), where_in(contradiction(*offender)), cutoff);
  else if (offender)
    line =
        fmt::format("but it is {}: alpha is {} to {} on it, and the cutoff is {}.", full_name(offender->is),
                    text_of(offender->alpha.least.alpha), text_of(offender->alpha.greatest.alpha), cutoff);
  constexpr double width = size + 2 * left, height = top + size + 70;
  Canvas canvas(width, height, title);
  with_textures(one, [&](const auto& mips) {
    draw_opaque(canvas, view, mips.front(), one);
    draw_texels(canvas, view, mips.front());
  });
  canvas.polygon(view(base), "none", blue, 1.5);
  if (offender) canvas.polygon(view(polygon), contradicts ? "url(#hatch)" : "none", vermilion, 3, 0.5);
  mask_margins(canvas, width, height);
  canvas.text({left, 34}, title, 19, ink, "start", true);
  canvas.text({left, 60}, line, 15);
  if (offender) {
    canvas.dot(view(in_first(one, contradiction(*offender))), 6, "#000000", "#ffffff");
    if (!contradicts) canvas.dot(view(in_first(one, offender->alpha.greatest)), 6, "#ffffff", "#000000");
  }
  const double y = top + size + 28;
  canvas.polygon({{left, y - 8}, {left + 18, y - 8}, {left + 18, y + 8}, {left, y + 8}}, "#bcd9c4", grey, 1);
  canvas.text({left + 26, y + 5}, "alpha is opaque", 13);
  canvas.polygon({{left + 136, y}, {left + 160, y}}, "none", vermilion, 3, 1, false);
  canvas.text({left + 168, y + 5}, "the micro-triangle", 13);
  canvas.polygon({{left + 300, y}, {left + 324, y}}, "none", blue, 1.5, 1, false);
  canvas.text({left + 332, y + 5}, "the base triangle", 13);
  canvas.dot({left + 456, y}, 6, "#000000", "#ffffff");
  canvas.text({left + 470, y + 5}, contradicts ? "the contradiction" : "least (white: greatest)", 13);
  canvas.text({left, y + 28}, "Squares are texels, numbers their stored alpha; y points down.", 13,
              "#555555");
  return canvas.str();
}

}  // namespace mmverify::proofs::bake
