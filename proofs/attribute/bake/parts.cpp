#include "proofs/attribute/bake/parts.hpp"

#include <fmt/ranges.h>

#include "proofs/attribute/elements.hpp"

namespace mmverify::proofs::attribute {

namespace slow = spec::attribute;
using spec::Rational128;

std::string name_of(MapForm form, std::uint32_t k) {
  if (form == MapForm::faces) return fmt::format("face {}", k);
  return "micro-vertex " + text_of(slow::vertex_at(slow::VertexOrder::w_minor, k, 16));
}

std::vector<std::uint32_t> judged_at(std::uint64_t count, std::uint64_t salt) {
  std::vector<std::uint32_t> at{0};
  const std::uint64_t between = count < 2 ? 0 : count - 2, step = between <= 6 ? 1 : between / 6;
  for (std::uint64_t k = 0; k < std::min<std::uint64_t>(between, 6); ++k)
    at.push_back(static_cast<std::uint32_t>(1 + k * step + (between <= 6 ? 0 : salt % step)));
  if (count > 1) at.push_back(static_cast<std::uint32_t>(count - 1));
  return at;
}

Finding compared(MapForm form, const std::vector<Rgba>& expected, const std::vector<Rgba>& got,
                 std::uint32_t tolerance) {
  if (got.empty()) return {.declined = true};
  if (got.size() != expected.size())
    return wrong(fmt::format("{} values", expected.size()), fmt::format("{}", got.size()));
  Finding found;
  for (std::uint32_t k = 0; k < got.size(); ++k) {
    const Match here = match(expected[k], got[k], tolerance);
    if (here == Match::wrong) {
      found.holds = false;
      found.in_words = [=, e = expected[k], g = got[k]] {
        return Words{fmt::format("{} at {}", text_of(e), name_of(form, k)), text_of(g)};
      };
      return found;
    }
    found.allowed = found.allowed || here == Match::within;
    found.answer = found.answer * 31 + std::bit_cast<std::uint32_t>(got[k]);
  }
  return found;
}

Law within_support(Law law) {
  const auto support = [](const Subject& s) -> const BakingSupport& {
    return subject_as<AttributeSubject>(s).functions.baking.support;
  };
  law.domain = [=, all = law.domain](const Subject& s, Level n) {
    const std::string declared = text_of(support(s));
    return all(s, n) + (declared.empty() ? "" : "; within what it declares: " + declared);
  };
  law.unfit = [=, fits = law.unfit](const Subject& s, Level n) -> std::optional<std::string> {
    if (auto why = fits(s, n)) return why;
    if (const Level last = support(s).max_level; n > last)
      return fmt::format("{} bakes up to level {}", s.name(), last);
    return std::nullopt;
  };
  return law;
}

std::function<void(Functions&)> bakes_another(MapForm form, std::function<void(BakeCase&)> change) {
  return [=](Functions& f) {
    MapBaker& baker = map_baker(f.baking, form);
    baker = [=, real = baker](const BakeCase& one, Level n) {
      BakeCase other = one;
      change(other);
      return real(other, n);
    };
  };
}

namespace {

/// The mean of a colour channel over shares.
Rational128 colour(const BakeCase& one, std::size_t c, Filter filter,
                   const slow::Shares<Rational128>& shares) {
  if (one.picture.meaning == Meaning::srgb && c < 3)
    return slow::mean(channel_of<slow::Srgb8>(one.picture, c, filter), shares);
  return slow::mean(channel_of<std::uint8_t>(one.picture, c, filter), shares);
}

/// A baker that averages with the shares that `shares_of` gives.
template <class SharesOf>
MapBaker with_shares(Filter filter, SharesOf shares_of) {
  return [=](const BakeCase& one, Level n) {
    std::vector<Rgba> map;
    for (const auto& shares : shares_of(one, n))
      map.push_back(true_codes(one.picture, filter, [&](const auto& t) { return slow::mean(t, shares); }));
    return map;
  };
}

/// Computes shares of every face from its corners in texels.
template <class OfFace>
auto each_face(OfFace of_face) {
  return [=](const BakeCase& one, Level n) {
    const auto uv = base_triangle<Rational128>(one.uv);
    std::vector<slow::Shares<Rational128>> all;
    for (std::uint32_t k = 0; k < slow::face_count(n); ++k)
      all.push_back(of_face(spec::bake::micro_triangle(uv, n, k, one.picture.width, one.picture.height)));
    return all;
  };
}

slow::Shares<Rational128> even(const std::vector<slow::TexturePoint<Rational128>>& at) {
  slow::Shares<Rational128> shares;
  const auto each = slow::fraction<Rational128>(1, static_cast<std::int64_t>(at.size()));
  for (const auto& p : at) shares.push_back({spec::bake::floored(p.x), spec::bake::floored(p.y), each});
  return shares;
}

/// A mutant that bakes faces, and their means, with the shares that `of_face` gives; map and mean agree.
std::function<void(Functions&)> of_faces(
    const std::function<slow::Shares<Rational128>(const slow::Polygon<Rational128>&)>& of_face) {
  return [=](Functions& f) {
    f.baking.faces = with_shares(Filter::nearest, each_face(of_face));
    f.baking.face_mean = [=](const BakeCase& one, Level n, std::size_t c, std::uint32_t k) {
      const auto uv = base_triangle<Rational128>(one.uv);
      return wide(
          colour(one, c, Filter::nearest,
                 of_face(spec::bake::micro_triangle(uv, n, k, one.picture.width, one.picture.height))));
    };
  };
}

/// The value, or where it is not in the set one that is.  Domain: the set has one below `values`.
template <class Value>
Value in_set(Set set, Value value, std::size_t values, std::uint32_t salt) {
  if (set.has(value)) return value;
  std::vector<Value> all;
  for (std::size_t k = 0; k < values; ++k)
    if (set.has(k)) all.push_back(static_cast<Value>(k));
  return all.at((salt + static_cast<std::size_t>(value)) % all.size());
}

template <std::size_t count>
void say_set(std::vector<std::string>& said, Set set, const std::array<const char*, count>& names) {
  std::vector<std::string> some;
  for (std::size_t k = 0; k < count; ++k)
    if (set.has(k)) some.emplace_back(names[k]);
  if (some.size() < count) said.push_back(fmt::format("{}", fmt::join(some, " and ")));
}

}  // namespace

std::function<void(Functions&)> rounds_half_down(MapForm form) {
  return [=](Functions& f) {
    MapBaker& baker = map_baker(f.baking, form);
    baker = [=, real = baker](const BakeCase& one, Level n) {
      std::vector<Rgba> map = real(one, n);
      const Filter filter = form == MapForm::faces ? Filter::nearest : one.picture.filter;
      const auto shares =
          form == MapForm::faces ? face_shares<Rational128>(one, n) : vertex_shares<Rational128>(one, n);
      for (std::size_t k = 0; k < map.size(); ++k)
        for (std::size_t c = one.picture.meaning == Meaning::linear ? 0 : 3; c < 4; ++c) {
          const auto twice = slow::fraction<Rational128>(510, 1) * colour(one, c, filter, shares[k]);
          if (twice == slow::fraction<Rational128>(2 * std::int64_t{map[k][c]} - 1, 1)) --map[k][c];
        }
      return map;
    };
  };
}

std::function<void(Functions&)> rounds_near_halves_up() {
  return [](Functions& f) {
    f.baking.faces = [real = f.baking.faces](const BakeCase& one, Level n) {
      using spec::Rational;
      std::vector<Rgba> map = real(one, n);
      if (n != 0 || map.empty() || one.picture.meaning != Meaning::linear) return map;
      const auto shares = face_shares<Rational>(one, n);
      for (std::size_t c = 0; c < 4; ++c) {
        const Rational code =
            slow::fraction<Rational>(255, 1) *
                slow::mean(channel_of<std::uint8_t>(one.picture, c, Filter::nearest), shares[0]) +
            slow::fraction<Rational>(1, 1'000'000'000);
        if (code >= slow::fraction<Rational>(2 * std::int64_t{map[0][c]} + 1, 2)) ++map[0][c];
      }
      return map;
    };
  };
}

std::function<void(Functions&)> averages_centres() {
  return of_faces([](const slow::Polygon<Rational128>& corners) {
    std::vector<slow::TexturePoint<Rational128>> centres;
    const auto half = slow::fraction<Rational128>(1, 2);
    slow::for_each_part(
        slow::Image<Rational128>(corners), Rational128(0), [&](std::int64_t i, std::int64_t j, const auto&) {
          const slow::TexturePoint<Rational128> centre{slow::fraction<Rational128>(i, 1) + half,
                                                       slow::fraction<Rational128>(j, 1) + half};
          bool left = true, right = true;
          for (std::size_t k = 0; k < 3; ++k) {
            const auto &p = corners[k], &q = corners[(k + 1) % 3];
            const Rational128 side = (q.x - p.x) * (centre.y - p.y) - (q.y - p.y) * (centre.x - p.x);
            left = left && side >= 0;
            right = right && side <= 0;
          }
          if (left || right) centres.push_back(centre);
        });
    return even(centres.empty() ? std::vector{spec::bake::centroid(corners)} : centres);
  });
}

std::function<void(Functions&)> averages_corners() {
  return of_faces([](const slow::Polygon<Rational128>& corners) { return even(corners); });
}

std::function<void(Functions&)> spreads_evenly() {
  return of_faces([](const slow::Polygon<Rational128>& corners) {
    if (spec::bake::has_area(corners)) return slow::shares_on(corners, Filter::nearest);
    // The ends of the segment, without its middle vertex; it is cut into pieces of equal weight.
    auto ends = corners;
    std::sort(ends.begin(), ends.end(),
              [](const auto& p, const auto& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
    const std::size_t pieces = 64;
    std::vector<slow::TexturePoint<Rational128>> at;
    for (std::size_t k = 0; k < pieces; ++k) {
      const auto f = slow::fraction<Rational128>(static_cast<std::int64_t>(2 * k + 1), 2 * pieces);
      at.push_back({ends[0].x + f * (ends[2].x - ends[0].x), ends[0].y + f * (ends[2].y - ends[0].y)});
    }
    return even(at);
  });
}

std::function<void(Functions&)> places_in_floats() {
  return [](Functions& f) {
    f.baking.vertices = [](const BakeCase& one, Level n) {
      std::vector<Rgba> map;
      const auto exact = [](float x) {
        return spec::bake::number<Rational>(spec::bake::Binary32{std::bit_cast<std::uint32_t>(x)});
      };
      const float step = 1.0f / static_cast<float>(spec::side(n));
      for (std::uint64_t k = 0; k < slow::vertex_count(n); ++k) {
        const auto v = slow::vertex_at(slow::VertexOrder::w_minor, k, n);
        const float s = static_cast<float>(v.i) * step, t = static_cast<float>(v.j) * step;
        const auto along = [&](std::size_t axis, std::uint32_t size) {
          const float p = one.uv[axis], q = one.uv[axis + 2], r = one.uv[axis + 4];
          return exact((p + (q - p) * s + (r - p) * t) * static_cast<float>(size));
        };
        const auto shares = slow::shares_at(
            slow::TexturePoint<Rational>{along(0, one.picture.width), along(1, one.picture.height)},
            one.picture.filter);
        map.push_back(true_codes(one.picture, one.picture.filter,
                                 [&](const auto& texture) { return slow::mean(texture, shares); }));
      }
      return map;
    };
  };
}

bool covers(const BakingSupport& s, const BakeCase& one) {
  const Picture& p = one.picture;
  return s.meanings.has(p.meaning) && s.filters.has(p.filter) && s.wraps.has(p.wrap_u) &&
         s.wraps.has(p.wrap_v) && (!s.same_wraps || p.wrap_u == p.wrap_v);
}

BakeCase fitted(const BakingSupport& s, BakeCase one) {
  if (covers(s, one)) return one;
  Picture& p = one.picture;
  // Half a mantissa: what a small change of a coordinate changes.
  const std::uint32_t salt = std::bit_cast<std::uint32_t>(one.uv[0] + one.uv[3]) >> 12;
  p.meaning = in_set(s.meanings, p.meaning, meaning_names.size(), salt);
  p.filter = in_set(s.filters, p.filter, filter_names.size(), salt);
  p.wrap_u = in_set(s.wraps, p.wrap_u, wrap_names.size(), salt);
  p.wrap_v = s.same_wraps ? p.wrap_u : in_set(s.wraps, p.wrap_v, wrap_names.size(), salt);
  return one;
}

std::string text_of(const BakingSupport& s) {
  std::vector<std::string> said;
  say_set(said, s.meanings, meaning_names);
  say_set(said, s.filters, filter_names);
  say_set(said, s.wraps, wrap_names);
  if (s.same_wraps) said.emplace_back("one addressing mode for u and v");
  if (s.tolerance != 0)
    said.push_back(fmt::format("within {} code{}", s.tolerance, s.tolerance == 1 ? "" : "s"));
  return fmt::format("{}", fmt::join(said, "; "));
}

}  // namespace mmverify::proofs::attribute
