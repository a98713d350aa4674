// Baked maps beside each other: across an edge, from level to level, of one colour.
#include "proofs/attribute/bake/parts.hpp"
#include "proofs/engine/random.hpp"

namespace mmverify::proofs::attribute {
namespace {

namespace slow = spec::attribute;

// ---- An edge from both sides

/// Two triangles that have the first one's edge 0-1, the other between its vertices `turn` and the next or before.
struct EdgeCase {
  BakeCase one;
  float u, v;          ///< of the other's third vertex
  std::uint32_t turn;  ///< 0..5: three places of the edge, both directions
};

/// Micro-vertex k of N on the edge from vertex a to vertex b, in W-minor order.
std::size_t on_edge(std::uint32_t a, std::uint32_t b, std::uint32_t k, Level n) {
  std::array<std::uint32_t, 3> weight{};
  weight[a] = spec::side(n) - k;
  weight[b] += k;
  return slow::vertex_index(slow::VertexOrder::w_minor, {weight[1], weight[2]}, n);
}

std::array<std::uint32_t, 3> places(std::uint32_t turn) {
  const std::uint32_t a = turn / 2, b = (a + 1) % 3, c = (a + 2) % 3;
  return turn % 2 == 0 ? std::array{a, b, c} : std::array{b, a, c};
}

Finding agrees(const AttributeSubject& s, Level n, const EdgeCase& c) {
  const BakingSupport& support = s.functions.baking.support;
  if (!covers(support, c.one)) return {.declined = true};
  const auto [a, b, third] = places(c.turn);
  BakeCase other = c.one;
  for (std::uint32_t axis = 0; axis < 2; ++axis) {
    other.uv[2 * a + axis] = c.one.uv[axis];
    other.uv[2 * b + axis] = c.one.uv[2 + axis];
    other.uv[2 * third + axis] = axis == 0 ? c.u : c.v;
  }
  const auto first = s.functions.baking.vertices(c.one, n), second = s.functions.baking.vertices(other, n);
  if (first.empty() || second.empty()) return {.declined = true};
  // Each of two codes may be off, one up and one down.
  Finding found;
  for (std::uint32_t k = 0; k <= spec::side(n); ++k) {
    const Rgba &here = first.at(on_edge(0, 1, k, n)), &there = second.at(on_edge(a, b, k, n));
    const Match both = match(here, there, 2 * support.tolerance);
    if (both == Match::wrong)
      return wrong(fmt::format("{} at {} of {} along the edge, as the first triangle has", text_of(here), k,
                               spec::side(n)),
                   text_of(there));
    found.allowed = found.allowed || both == Match::within;
    found.answer = found.answer * 31 + std::bit_cast<std::uint32_t>(here);
  }
  return found;
}

EdgeCase edge_case(Level n, std::uint64_t k, std::uint64_t seed) {
  Random random(seed, 0x656467 + n, k);
  const auto any = [&] { return static_cast<float>(random.between(-4096, 8192)) / 4096; };
  EdgeCase c{sample_case(seed, n, k), any(), any(), static_cast<std::uint32_t>(k % 6)};
  if (k % 8 < 6) {  // far out, in all of binary32's bits, and full of contrast: where positions round
    for (float& x : c.one.uv) x = static_cast<float>(random.between(-(1 << 26), 1 << 26)) / (1 << 22);
    for (Rgba& t : c.one.picture.texels)
      for (std::uint8_t& code : t) code = random.below(2) == 0 ? 0 : 255;
  }
  return c;
}

EdgeCase read_edge_case(Level, const std::string& text) {
  const auto colon = text.rfind(':');
  if (colon == std::string::npos) throw BadCase(fmt::format("'{:.60}': end with :U,V,TURN", text));
  EdgeCase c{read_bake_case(text.substr(0, colon)), 0, 0, 0};
  char* end = nullptr;
  const std::string rest = text.substr(colon + 1);
  c.u = std::strtof(rest.c_str(), &end);
  if (*end != ',') throw BadCase(fmt::format("'{:.60}': end with :U,V,TURN", text));
  c.v = std::strtof(end + 1, &end);
  if (*end != ',' || end[1] < '0' || end[1] > '5' || end[2] != 0 || !(std::fabs(c.u) < 64) ||
      !(std::fabs(c.v) < 64))
    throw BadCase(fmt::format("'{:.60}': end with :U,V,TURN, the turn in 0..5", text));
  c.turn = static_cast<std::uint32_t>(end[1] - '0');
  return c;
}

bool clockwise(const BakeCase& one) {
  const auto& p = one.uv;
  return (p[2] - p[0]) * (p[5] - p[1]) < (p[3] - p[1]) * (p[4] - p[0]);
}

Law edge_law() {
  Cases<EdgeCase> cases;
  cases.count = {240, 20'000};
  cases.number = edge_case;
  cases.text = [](Level, const EdgeCase& c) {
    return fmt::format("{}:{:a},{:a},{}", text_of(c.one), c.u, c.v, c.turn);
  };
  cases.read = read_edge_case;
  cases.check = agrees;
  cases.fit = [](const AttributeSubject& s, const EdgeCase& c) {
    EdgeCase other = c;
    other.one = fitted_case(s, c.one);
    return other;
  };
  cases.chunk = 8;
  return on_cases(
      {.id = "attribute.bake_edge_agrees",
       .says = "two triangles with the same coordinates at both ends of an edge have the same codes on its "
               "N+1 micro-vertices",
       .source = "Color and Attribute Micromaps, 3.2; continuity across base triangles",
       .method = Method::sample,
       .subjects = {"attribute"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 9}, .seconds = 0.3},
       .domain = "edges of sampled triangles beside another, in all 6 places of the other",
       .mutants = {mutant("a margin of 2^-10 taken off clockwise triangles at level 5", "attribute", {5, 5},
                          [](Functions& f) {
                            f.baking.vertices = [real = f.baking.vertices](const BakeCase& one, Level n) {
                              BakeCase other = one;
                              if (n == 5 && clockwise(one)) other.uv[0] += 0x1p-10f;
                              return real(other, n);
                            };
                          })}},
      needing({bakes_vertices}), cases);
}

// ---- The mean of four children

struct FaceCase {
  BakeCase one;
  std::uint32_t index;
};

constexpr Entry means_faces{"face_mean", [](const Functions& f) { return bool(f.baking.face_mean); }};

std::string ratio(const Rational& q) {
  return fmt::format("{}/{}", q.numerator().str(), q.denominator().str());
}

/// Channel c is texel c alone: a mean is linear in the texels, so that these four say all.
BakeCase lone_texels(std::uint64_t spot, Filter filter) {
  BakeCase one = family_case(spot, 0, filter);
  one.picture.border = {0, 0, 0, 0};
  for (std::size_t t = 0; t < 4; ++t)
    for (std::size_t c = 0; c < 4; ++c) one.picture.texels[t][c] = t == c ? 255 : 0;
  return one;
}

Finding is_parent(const AttributeSubject& s, Level n, const FaceCase& f) {
  std::uint64_t digest = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    const Rational parent = s.functions.baking.face_mean(f.one, n, c, f.index);
    Rational children(0);
    for (std::uint32_t k = 0; k < 4; ++k)
      children += s.functions.baking.face_mean(f.one, n + 1, c, 4 * f.index + k);
    if (children != parent * 4)
      return wrong(fmt::format("{} of channel {} at face {}, the mean of its children", ratio(children / 4),
                               c, f.index),
                   ratio(parent));
    digest = digest * 31 + static_cast<std::uint64_t>(spec::Integer(parent.numerator() % 65521));
  }
  return {digest};
}

Law parent_law() {
  Cases<FaceCase> cases;
  cases.count = [](Level n, const Run&) { return 2 * family_spots() * slow::face_count(n); };
  cases.number = [](Level n, std::uint64_t k, std::uint64_t) {
    const std::uint64_t faces = slow::face_count(n), rest = k / faces;
    return FaceCase{lone_texels(rest / 2, rest % 2 == 0 ? Filter::nearest : Filter::bilinear),
                    static_cast<std::uint32_t>(k % faces)};
  };
  cases.text = [](Level, const FaceCase& f) { return fmt::format("{}:{}", text_of(f.one), f.index); };
  cases.read = [](Level n, const std::string& text) {
    const auto colon = text.rfind(':');
    const std::string digits = colon == std::string::npos ? "" : text.substr(colon + 1);
    if (digits.empty() || digits.size() > 8 || digits.find_first_not_of("0123456789") != std::string::npos ||
        std::stoul(digits) >= slow::face_count(n))
      throw BadCase(fmt::format("'{:.60}': end with a colon and a face of level {}", text, n));
    return FaceCase{read_bake_case(text.substr(0, colon)), static_cast<std::uint32_t>(std::stoul(digits))};
  };
  cases.check = is_parent;
  cases.chunk = 4;
  return on_cases({.id = "attribute.face_mean_is_parent",
                   .says = "before rounding, a face's mean is the mean of its four children, also where the "
                           "triangle is a segment or a point in the texture",
                   .source = "Color and Attribute Micromaps, 4.4 and 5.1",
                   .subjects = {"attribute-spec"},
                   .tiers = {.fast = {0, 1}, .long_run = {0, 3}, .seconds = 1},
                   .domain = "each texel of 2x2 alone, nearest and bilinear, 8 pairs of addressing modes, 7 "
                             "triangles, all faces",
                   .mutants = {mutant("along a segment all parts weigh the same", "attribute-spec", {0, 0},
                                      spreads_evenly())}},
                  needing({means_faces}), cases);
}

// ---- One colour

Finding is_constant(const AttributeSubject& s, Level n, const BakeCase& one) {
  const Baking& baking = s.functions.baking;
  if (!covers(baking.support, one) || is_normal(one.picture.meaning)) return {.declined = true};
  const Rgba colour = one.picture.texels[0];
  Finding both{.answer = std::bit_cast<std::uint32_t>(colour)};
  for (const MapForm form : {MapForm::vertices, MapForm::faces}) {
    const std::vector<Rgba> expected(form == MapForm::faces ? slow::face_count(n) : slow::vertex_count(n),
                                     colour);
    const Finding found = compared(form, expected, map_baker(baking, form)(one, n), baking.support.tolerance);
    if (!found.holds || found.declined) return found;
    both.allowed = both.allowed || found.allowed;
  }
  return both;
}

Law constant_law() {
  Cases<BakeCase> cases;
  cases.count = 256 * family_spots();
  cases.number = [](Level, std::uint64_t k, std::uint64_t) {
    const auto code = static_cast<std::uint8_t>(k % 256);
    BakeCase one = family_case(k / 256, 0, k % 3 == 0 ? Filter::nearest : Filter::bilinear);
    const Rgba colour{code, static_cast<std::uint8_t>(255 - code), static_cast<std::uint8_t>(code * 7), code};
    one.picture.texels.assign(4, colour);
    one.picture.border = colour;
    return one;
  };
  cases.text = [](Level, const BakeCase& one) { return text_of(one); };
  cases.read = [](Level, const std::string& text) {
    BakeCase one = read_bake_case(text);
    for (const Rgba& texel : one.picture.texels)
      if (texel != one.picture.texels[0] || texel != one.picture.border ||
          (one.picture.meaning != Meaning::linear && one.picture.meaning != Meaning::srgb))
        throw BadCase(fmt::format("'{:.60}': a picture of one colour, its border's too", text));
    return one;
  };
  cases.check = is_constant;
  cases.fit = fitted_case;
  const auto spoilt = [](MapForm form, auto meant, std::size_t channel) {
    return [=](Functions& f) {
      MapBaker& baker = map_baker(f.baking, form);
      baker = [=, real = baker](const BakeCase& one, Level n) {
        std::vector<Rgba> map = real(one, n);
        if (meant(one) && map.back()[channel] > 0) --map.back()[channel];
        return map;
      };
    };
  };
  return on_cases({.id = "attribute.bake_constant",
                   .says = "a texture of one colour bakes to that colour, linear or sRGB",
                   .source = "weights sum to 1, and each code is the one that its own number is rounded to",
                   .subjects = {"attribute"},
                   .tiers = {.fast = {0, 1}, .long_run = {0, 5}, .seconds = 0.5},
                   .domain = "256 colours with all codes in each channel, 8 pairs of addressing modes, "
                             "linear and sRGB, 7 triangles",
                   .mutants = {mutant("code 11, the first beyond the line, is 10", "attribute", {1, 1},
                                      spoilt(
                                          MapForm::vertices,
                                          [](const BakeCase& one) {
                                            return one.picture.meaning == Meaning::srgb &&
                                                   one.picture.texels[0][0] == 11;
                                          },
                                          0))}},
                  needing({bakes_vertices, bakes_faces}), cases);
}

}  // namespace

std::vector<Law> bake_relation_laws() {
  return {within_support(edge_law()), parent_law(), within_support(constant_law())};
}

}  // namespace mmverify::proofs::attribute
