// The error of a map, and the curve of sRGB.
#include "proofs/attribute/bake/parts.hpp"
#include "proofs/engine/random.hpp"
#include "spec/attribute/error.hpp"

namespace mmverify::proofs::attribute {
namespace {

namespace slow = spec::attribute;

constexpr Entry bounds_errors{"error", [](const Functions& f) { return bool(f.baking.error); }};
constexpr Entry knows_light{"light", [](const Functions& f) { return bool(f.baking.light); }};

struct ErrorCase {
  BakeCase one;
  MapForm form = MapForm::faces;
};

constexpr std::int64_t points_to_a_side = 24;  // no power of 2, so that they fall beside micro-edges as well

/// The texture sampled bilinearly at (u, v) of the triangle, less what the map shows there.
template <class Q>
Q difference_in(const BakeCase& one, Level n, MapForm form, const std::vector<Rgba>& map, std::size_t c,
                const Q& u, const Q& v) {
  const auto uv = base_triangle<Q>(one.uv);
  const auto along = [&](Q slow::TexturePoint<Q>::*axis, std::uint32_t size) {
    return Q((uv[0].*axis + u * (uv[1].*axis - uv[0].*axis) + v * (uv[2].*axis - uv[0].*axis)) * Q(size));
  };
  const auto shares =
      slow::shares_at(slow::TexturePoint<Q>{along(&slow::TexturePoint<Q>::x, one.picture.width),
                                            along(&slow::TexturePoint<Q>::y, one.picture.height)},
                      Filter::bilinear);
  const Q texture = one.picture.meaning == Meaning::srgb && c < 3
                        ? slow::mean(channel_of<slow::Srgb8>(one.picture, c, Filter::bilinear), shares)
                        : slow::mean(channel_of<std::uint8_t>(one.picture, c, Filter::bilinear), shares);
  const std::uint32_t index = spec::index::reference(spec::Point<Rational>{wide(u), wide(v)}, n);
  if (form == MapForm::faces) return texture - number_of<Q>(one.picture, c, map[index][c]);
  // Linear between the corners p, q, r: by areas.
  const auto corners = spec::index::corners(index, n);
  const Q N(spec::side(n));
  const auto area = [&](std::size_t k) {
    const auto &p = corners[(k + 1) % 3], &q = corners[(k + 2) % 3];
    return Q((Q(q.i) - Q(p.i)) * (v * N - Q(p.j)) - (Q(q.j) - Q(p.j)) * (u * N - Q(p.i)));
  };
  const Q whole = area(0) + area(1) + area(2);
  Q shown(0);
  for (std::size_t k = 0; k < 3; ++k)
    shown +=
        area(k) / whole *
        number_of<Q>(one.picture, c, map[slow::vertex_index(slow::VertexOrder::w_minor, corners[k], n)][c]);
  return texture - shown;
}

/// At u = a / side, v = b / side.
Rational difference(const BakeCase& one, Level n, MapForm form, const std::vector<Rgba>& map, std::size_t c,
                    std::int64_t a, std::int64_t b, std::int64_t side) {
  return in_few_bits([&]<class Q>() {
    return wide(
        difference_in<Q>(one, n, form, map, c, slow::fraction<Q>(a, side), slow::fraction<Q>(b, side)));
  });
}

double about(const Rational& q) {
  return static_cast<double>(boost::multiprecision::cpp_rational(q.numerator(), q.denominator()));
}

Finding is_bound(const AttributeSubject& s, Level n, const ErrorCase& e) {
  const Baking &judged = s.functions.baking, &exact = built_in("attribute-spec")->functions.baking;
  const std::vector<Rgba> map = map_baker(built_in("attribute")->functions.baking, e.form)(e.one, n);
  const auto got = judged.error(e.one, n, e.form, map), truth = exact.error(e.one, n, e.form, map);
  const Rational slack =
      slow::number<Rational>(slow::Binary32{std::bit_cast<std::uint32_t>(static_cast<float>(judged.slack))});
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::int64_t a = 0; a <= points_to_a_side; ++a)
      for (std::int64_t b = (a + static_cast<std::int64_t>(c)) % 4; a + b <= points_to_a_side; b += 4) {
        const Rational here = difference(e.one, n, e.form, map, c, a, b, points_to_a_side),
                       size = here < 0 ? Rational(-here) : here;
        if (size > got[c].largest)
          return wrong(fmt::format("{:.9g} at the least: channel {} at u={}/{}, v={}/{}", about(size), c, a,
                                   points_to_a_side, b, points_to_a_side),
                       fmt::format("{:.9g}", about(got[c].largest)));
      }
    for (const auto& [what, mine, of] : {std::tuple{"largest", got[c].largest, truth[c].largest},
                                         std::tuple{"mean square", got[c].square, truth[c].square}})
      if (mine < of || mine > of + slack)
        return wrong(fmt::format("{} error {:.12g} of channel {}", what, about(of), c),
                     fmt::format("{:.12g}", about(mine)));
  }
  return {static_cast<std::uint64_t>(about(truth[0].largest) * 0x1p40)};
}

std::function<void(Functions&)> errors_of_another(std::function<void(BakeCase&)> change) {
  return [=](Functions& f) {
    f.baking.error = [=, real = f.baking.error](const BakeCase& one, Level n, MapForm form,
                                                const std::vector<Rgba>& map) {
      BakeCase other = one;
      change(other);
      return real(other, n, form, map);
    };
  };
}

Law error_law() {
  Cases<ErrorCase> cases;
  cases.count = [](Level n, const Run& run) {
    return std::uint64_t{run.tier == Tier::fast ? (n == 0 ? 20u : n == 1 ? 8u : 3u) : 1'000u};
  };
  cases.number = [](Level n, std::uint64_t k, std::uint64_t seed) {
    ErrorCase e{sample_case(seed, n, 8 * k + k % 2), k % 4 < 2 ? MapForm::vertices : MapForm::faces};
    Picture& p = e.one.picture;
    p.width = 1 + p.width % 5;
    p.height = 1 + p.height % 5;
    p.texels.resize(std::size_t{p.width} * p.height, Rgba{9, 200, 31, 128});
    return e;
  };
  cases.text = [](Level, const ErrorCase& e) {
    return fmt::format("{}:{}", e.form == MapForm::faces ? "faces" : "vertices", text_of(e.one));
  };
  cases.read = [](Level, const std::string& text) {
    const auto colon = text.find(':');
    const std::string form = text.substr(0, colon);
    if (colon == std::string::npos || (form != "faces" && form != "vertices"))
      throw BadCase(fmt::format("'{:.60}': begin with faces: or vertices:", text));
    return ErrorCase{read_bake_case(text.substr(colon + 1)),
                     form == "faces" ? MapForm::faces : MapForm::vertices};
  };
  cases.check = is_bound;
  cases.chunk = 1;
  return on_cases(
      {.id = "attribute.error_is_bound",
       .says = "no point of a map is further from the texture than its stated largest error, which is the "
               "exact one, as is the mean square, up to the slack that is declared",
       .source = "spec/attribute/error.hpp; Color and Attribute Micromaps, 6.3",
       .method = Method::sample,
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 2}, .long_run = {0, 3}, .seconds = 1},
       .domain = "faces and vertices of sampled cases, 2x2 to 5x5 texels, each at 337 points",
       .mutants = {mutant("mirrored as repeated", "attribute", {0, 0}, errors_of_another([](BakeCase& one) {
                            if (one.picture.wrap_u == Wrap::mirrored_repeat)
                              one.picture.wrap_u = Wrap::repeat;
                          }))}},
      needing({bounds_errors}), cases);
}

Finding is_nearest(const AttributeSubject& s, Level, std::uint32_t m) {
  const std::uint32_t got = s.functions.baking.light(m);
  // k is the nearest where light < k + 1/2 and not light <= k - 1/2.
  const auto beyond = [&](std::int64_t halves) {
    return slow::reaches_light(spec::Integer(halves), slow::light_bits + 1, m);
  };
  const std::int64_t k = got;
  if (beyond(2 * k + 1) && (k == 0 || !beyond(2 * k - 1))) return {got};
  const std::int64_t right = slow::nearest_light(m);
  return wrong(fmt::format("{} / 2^24 at {} / 510", right, m), fmt::format("{}", got));
}

Law light_law() {
  Cases<std::uint32_t> cases;
  cases.count = 511;
  cases.number = [](Level, std::uint64_t k, std::uint64_t) { return static_cast<std::uint32_t>(k); };
  cases.text = [](Level, const std::uint32_t& m) { return fmt::format("m={}", m); };
  cases.read = [](Level, const std::string& text) {
    if (!text.starts_with("m=") || text.size() > 5 || text.size() < 3 ||
        text.find_first_not_of("0123456789", 2) != std::string::npos || std::stoul(text.substr(2)) > 510)
      throw BadCase(fmt::format("'{:.60}': write m=0 to m=510", text));
    return static_cast<std::uint32_t>(std::stoul(text.substr(2)));
  };
  cases.check = is_nearest;
  const auto light = [](auto change) {
    return [=](Functions& f) {
      f.baking.light = [=, real = f.baking.light](std::uint32_t m) { return change(m, real(m)); };
    };
  };
  return on_cases(
      {.id = "attribute.srgb_table",
       .says = "linear light of each code, and of each middle between two, is the nearest of 2^24 to the "
               "sRGB curve: x >= r^(12/5) where x^5 >= r^12",
       .source = "IEC 61966-2-1; spec/attribute/colour.hpp",
       .subjects = {"attribute-spec", "attribute"},
       .tiers = {.fast = {0, 0}, .long_run = {0, 0}, .seconds = 0.1},
       .domain = "the 256 codes and the 255 middles",
       .how = "exhaustive, whole numbers",
       .mutants = {mutant(
           "the line ends one code later", "attribute", {0, 0}, light([](std::uint32_t m, std::uint32_t x) {
             return m == 22 ? static_cast<std::uint32_t>(std::floor(m / 510.0 / 12.92 * 0x1p24 + 0.5)) : x;
           }))}},
      needing({knows_light}), cases);
}

}  // namespace

std::vector<Law> bake_error_laws() { return {error_law(), light_law()}; }

}  // namespace mmverify::proofs::attribute
