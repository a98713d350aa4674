// Laws of maps from textures: all cases of a family, and samples with binary32 coordinates.
#include "proofs/attribute/laws.hpp"

#include <boost/integer/common_factor.hpp>

#include "proofs/attribute/bake/parts.hpp"

namespace mmverify::proofs::attribute {
namespace {

namespace slow = spec::attribute;
using spec::Rational128;

/// A case of the family, known by its numbers, or one read from text.
struct Case {
  BakeCase one;
  std::uint64_t spot = 0, texture = 0;
  bool of_family = false;
};

/// The baked codes of one channel at a spot, for all 81 textures and every element, in linear light or as stored
/// codes.
class SpotCodes {
 public:
  const std::vector<std::uint8_t>& of(MapForm form, Level n, const BakeCase& one, bool srgb) {
    std::call_once(once_[srgb], [&] { fill(form, n, one, srgb); });
    return codes_[srgb];
  }

 private:
  void fill(MapForm form, Level n, const BakeCase& one, bool srgb) {
    using Whole = Rational128::int_type;
    const Filter filter = form == MapForm::faces ? Filter::nearest : one.picture.filter;
    const auto all =
        form == MapForm::faces ? face_shares<Rational128>(one, n) : vertex_shares<Rational128>(one, n);
    // The weights of the four texels and the border, as whole multiples of a common fraction.
    constexpr std::size_t border = 4;
    const auto lone = channel_of<std::uint8_t>(one.picture, 0, filter);
    codes_[srgb].resize(family_textures * all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      std::array<Rational128, 5> weight;
      for (const auto& s : all[k]) {
        const auto x = spec::bake::wrapped(lone.wrap_x, s.i, 2), y = spec::bake::wrapped(lone.wrap_y, s.j, 2);
        weight[x && y ? *x + 2 * *y : border] += s.weight;
      }
      Whole common(1);
      for (const Rational128& w : weight) common = boost::integer::lcm(common, w.denominator());
      std::array<Whole, 5> part;
      for (std::size_t t = 0; t < 5; ++t)
        part[t] = weight[t].numerator() * (common / weight[t].denominator());
      for (std::uint64_t texture = 0; texture < family_textures; ++texture) {
        std::uint64_t rest = texture;
        std::array<std::uint8_t, 5> code{};
        for (std::size_t t = 0; t < 4; ++t, rest /= 3) code[t] = family_alphabet[rest % 3];
        code[border] = one.picture.border[0];
        Whole sum(0);
        for (std::size_t t = 0; t < 5; ++t) sum += part[t] * Whole(srgb ? slow::light_of(code[t]) : code[t]);
        std::uint8_t& to = codes_[srgb][texture * all.size() + k];
        if (srgb)
          to = slow::Rounded<slow::Srgb8>::of(Rational128(sum, common << slow::light_bits)).code;
        else
          to = slow::Rounded<std::uint8_t>::of(Rational128(sum, common * 255));
      }
    }
  }

  std::array<std::once_flag, 2> once_;
  std::array<std::vector<std::uint8_t>, 2> codes_;
};

std::vector<Rgba> truth(MapForm form, Level n, const Case& c) {
  if (!c.of_family) return form == MapForm::faces ? true_faces(c.one, n) : true_vertices(c.one, n);
  constexpr std::size_t levels = 6, kinds = 3;  // faces, vertices bilinear, vertices nearest
  static const auto slots = std::make_unique<SpotCodes[]>(kinds * levels * family_spots());
  const std::size_t kind = form == MapForm::faces ? 0 : c.one.picture.filter == Filter::bilinear ? 1 : 2;
  SpotCodes& slot = slots[(kind * levels + n) * family_spots() + c.spot];
  std::vector<Rgba> map(form == MapForm::faces ? slow::face_count(n) : slow::vertex_count(n));
  for (std::size_t channel = 0; channel < 4; ++channel) {
    const auto& codes = slot.of(form, n, c.one, c.one.picture.meaning == Meaning::srgb && channel < 3);
    const std::uint64_t first = family_texture(c.texture, channel) * map.size();
    for (std::size_t k = 0; k < map.size(); ++k) map[k][channel] = codes[first + k];
  }
  return map;
}

Cases<Case> family_of(MapForm form) {
  Cases<Case> cases;
  const std::uint64_t filters = form == MapForm::faces ? 1 : 2;
  cases.count = family_textures * filters * family_spots();
  cases.number = [=](Level, std::uint64_t k, std::uint64_t) {
    const std::uint64_t texture = k % family_textures, rest = k / family_textures;
    const Filter filter =
        rest % filters == 0 && form == MapForm::vertices ? Filter::bilinear : Filter::nearest;
    return Case{family_case(rest / filters, texture, filter), rest / filters, texture, true};
  };
  cases.text = [](Level, const Case& c) { return text_of(c.one); };
  cases.read = [](Level, const std::string& text) { return Case{read_bake_case(text)}; };
  cases.check = [form](const AttributeSubject& s, Level n, const Case& c) -> Finding {
    const Baking& baking = s.functions.baking;
    if (!covers(baking.support, c.one)) return {.declined = true};
    return compared(form, truth(form, n, c), map_baker(baking, form)(c.one, n), baking.support.tolerance);
  };
  cases.fit = [](const AttributeSubject& s, const Case& c) {
    const BakingSupport& support = s.functions.baking.support;
    if (covers(support, c.one)) return c;
    Case other = c;
    other.one = fitted(support, c.one);
    const std::optional<std::uint64_t> spot = family_spot(other.one);
    other.of_family = spot.has_value();
    other.spot = spot.value_or(0);
    return other;
  };
  cases.chunk = 27;
  return cases;
}

const auto srgb_as_codes = [](BakeCase& one) {
  if (one.picture.meaning == Meaning::srgb) one.picture.meaning = Meaning::linear;
};
const auto centres_at_corners = [](BakeCase& one) {
  if (one.picture.filter == Filter::nearest) return;
  for (std::size_t k = 0; k < 6; ++k)
    one.uv[k] += 0.5f / static_cast<float>(k % 2 == 0 ? one.picture.width : one.picture.height);
};
const auto rows_from_below = [](BakeCase& one) {
  Picture& p = one.picture;
  if (p.wrap_u != Wrap::repeat || p.wrap_v != Wrap::clamp_to_edge) return;
  std::swap(p.texels[0], p.texels[2]);
  std::swap(p.texels[1], p.texels[3]);
};

Law vertex_law() {
  return on_cases({.id = "attribute.bake_vertex",
                   .says = "a micro-vertex has what the sampler gives there, bilinear or nearest, as the "
                           "code it is rounded to, half up",
                   .source = cam_5,
                   .subjects = {"attribute"},
                   .tiers = {.fast = {0, 2}, .long_run = {0, 4}, .seconds = 1},
                   .domain = family_domain(),
                   .how = "exhaustive, rational",
                   .mutants = {mutant("what lies in the middle is rounded down", "attribute", {1, 1},
                                      rounds_half_down(MapForm::vertices))}},
                  needing({bakes_vertices}), family_of(MapForm::vertices));
}

Law face_law() {
  return on_cases({.id = "attribute.bake_face",
                   .says = "a face has the mean of the texels under it, each by its share of the area, as "
                           "the code it is rounded to, half up",
                   .source = cam_5,
                   .subjects = {"attribute"},
                   .tiers = {.fast = {0, 2}, .long_run = {0, 4}, .seconds = 1},
                   .domain = family_domain(),
                   .how = "exhaustive, rational",
                   .mutants = {mutant("the texels whose centres lie inside, each the same", "attribute",
                                      {2, 2}, averages_centres())}},
                  needing({bakes_faces}), family_of(MapForm::faces));
}

Finding sampled(const AttributeSubject& s, Level n, const BakeCase& one) {
  const Baking& baking = s.functions.baking;
  if (!covers(baking.support, one)) return {.declined = true};
  return judged(one, n, baking.support.tolerance,
                [&](MapForm form) -> const MapBaker& { return map_baker(baking, form); });
}

/// Averages a direction's stored codes without renormalising.
std::function<void(Functions&)> not_renormalised() {
  return [](Functions& f) {
    f.baking.faces = [real = f.baking.faces](const BakeCase& one, Level n) {
      BakeCase other = one;
      if (other.picture.meaning == Meaning::normal) other.picture.meaning = Meaning::linear;
      return real(other, n);
    };
  };
}

Law floats_law() {
  Cases<BakeCase> cases;
  cases.count = [](Level n, const Run& run) {
    return std::uint64_t{run.tier == Tier::fast ? (n < 5 ? 64u : 24u) : 8'000u};
  };
  cases.number = [](Level n, std::uint64_t k, std::uint64_t seed) {
    // Only level 0 has such a case: at a finer level every face would have to be cut as finely.
    if (n == 0 && k % 8 == 6) return near_half_case(seed, n, k);
    // At levels 0 and 1 all elements are judged.
    if (n <= 1 && k % 16 == 3) return long_row_case(seed, n, k);
    return n <= 7 && k % 8 == 4 ? beside_lines_case(seed, n, k) : sample_case(seed, n, k);
  };
  cases.text = [](Level, const BakeCase& one) { return text_of(one); };
  cases.read = [](Level, const std::string& text) { return read_bake_case(text); };
  cases.check = sampled;
  cases.fit = fitted_case;
  cases.chunk = 4;
  return on_cases(
      {.id = "attribute.bake_on_floats",
       .says = "micro-vertices and faces are exact on binary32's coordinates, directions are made one unit "
               "long again and the mean's length is kept",
       .source = std::string(cam_5) + "; glTF 2.0, normalTexture",
       .method = Method::sample,
       .subjects = {"attribute"},
       .tiers = {.fast = {0, 7}, .long_run = {0, 9}, .seconds = 1},
       .domain = "textures of up to 9x7 texels, to level 1 some of up to 320 in a row, all modes and "
                 "meanings, means beside halves, micro-vertices beside lines; up to 8 values of each map",
       .mutants = {mutant("directions not made one unit long again", "attribute", {1, 3},
                          not_renormalised())}},
      needing({bakes_vertices, bakes_faces}), cases);
}

}  // namespace

std::vector<Law> bake_map_laws() {
  return {within_support(vertex_law()), within_support(face_law()), within_support(floats_law())};
}

std::vector<Law> bake_laws() {
  std::vector<Law> all;
  for (const auto& group :
       {bake_map_laws(), bake_texel_laws(), bake_relation_laws(), bake_error_laws(), plan_laws()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

}  // namespace mmverify::proofs::attribute
