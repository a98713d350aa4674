// Laws of maps from textures with more than 8 bits a channel.
#include <cmath>

#include "proofs/attribute/bake/parts.hpp"

namespace mmverify::proofs::attribute {
namespace {

using spec::Rational;
namespace slow = spec::attribute;

/// Cases of a channel: their draw, text and check.  `few`: their number in the fast tier.
template <class Channel>
Cases<BakeCaseOf<Channel>> cases_of(BakeCaseOf<Channel> (*draw)(std::uint64_t, Level, std::uint64_t),
                                    Bakers<Channel> Baking::*bakers, std::uint64_t few) {
  Cases<BakeCaseOf<Channel>> cases;
  cases.count = {few, 100 * few};
  cases.number = [=](Level n, std::uint64_t k, std::uint64_t seed) { return draw(seed, n, k); };
  cases.text = [](Level, const BakeCaseOf<Channel>& one) { return text_of(one); };
  cases.read = [](Level, const std::string& text) { return read_bake_case_of<Channel>(text); };
  cases.check = [=](const AttributeSubject& s, Level n, const BakeCaseOf<Channel>& one) {
    const Bakers<Channel>& of = s.functions.baking.*bakers;
    return judged(
        one, n, 0, [&](MapForm form) -> const auto& { return of.of(form); });
  };
  cases.chunk = 4;
  return cases;
}

/// A mutant that changes the cases or the maps of a baker: change(form, level, case, real baker).
template <class Channel, class Change>
std::function<void(Functions&)> baking(Bakers<Channel> Baking::*bakers, Change change) {
  return [=](Functions& f) {
    for (const MapForm form : {MapForm::faces, MapForm::vertices}) {
      MapBakerOf<Channel>& baker = (f.baking.*bakers).of(form);
      baker = [=, real = baker](const BakeCaseOf<Channel>& one, Level n) {
        return change(form, n, one, real);
      };
    }
  };
}

template <class Channel, class Change>
std::function<void(Functions&)> baking_another(Bakers<Channel> Baking::*bakers, Change change) {
  return baking(bakers, [=](MapForm, Level n, BakeCaseOf<Channel> one, const MapBakerOf<Channel>& real) {
    change(n, one.picture);
    return real(one, n);
  });
}

/// The exact value of a channel at an element.  Texel: the specification's type.
template <class Texel, class Channel>
Rational value_at(MapForm form, const BakeCaseOf<Channel>& one, Level n, std::uint32_t k, std::size_t c) {
  const auto uv = base_triangle<Rational>(one.uv);
  const auto texture =
      channel_of<Texel>(one.picture, c, form == MapForm::faces ? Filter::nearest : one.picture.filter);
  return form == MapForm::faces
             ? slow::face_value(texture, uv, n, k)
             : slow::vertex_value(texture, uv, n, slow::vertex_at(slow::VertexOrder::w_minor, k, n));
}

// ---- 16 bits

using Picture16 = PictureOf<std::uint16_t>;

constexpr Entry bakes_vertices_16{"vertices of 16 bits",
                                  [](const Functions& f) { return bool(f.baking.wide.vertices); }};
constexpr Entry bakes_faces_16{"faces of 16 bits",
                               [](const Functions& f) { return bool(f.baking.wide.faces); }};

template <class Change>
void each_code(Picture16& p, Change change) {
  for (auto& texel : p.texels)
    for (std::uint16_t& code : texel) change(code);
  for (std::uint16_t& code : p.border) change(code);
}

/// Lowers linear codes by one if the exact value lies in the middle between two codes.
std::function<void(Functions&)> rounds_16_half_down() {
  return baking(&Baking::wide, [](MapForm form, Level n, const BakeCaseOf<std::uint16_t>& one,
                                  const MapBakerOf<std::uint16_t>& real) {
    auto map = real(one, n);
    if (one.picture.meaning != Meaning::linear) return map;
    for (std::uint32_t k = 0; k < map.size(); ++k)
      for (std::size_t c = 0; c < 4; ++c)
        if (value_at<std::uint16_t>(form, one, n, k, c) * 131070 == Rational(2 * std::int64_t{map[k][c]} - 1))
          --map[k][c];
    return map;
  });
}

Law texels16_law() {
  const auto bytes_swapped = [](std::uint16_t& code) {
    code = static_cast<std::uint16_t>(code << 8 | code >> 8);
  };
  return on_cases(
      {.id = "attribute.bake_texels16",
       .says = "of textures of 16 bits a channel micro-vertices and faces have the exact number as the code "
               "it is rounded to, half up, colours as normals",
       .source = std::string(cam_5) + "; Vulkan, Conversion From Normalized Fixed-Point to Floating-Point",
       .method = Method::sample,
       .subjects = {"attribute"},
       .tiers = {.fast = {0, 4}, .long_run = {0, 8}, .seconds = 0.5},
       .domain = "textures of up to 9x7 texels of 16 bits, all modes, linear and normals, a quarter full of "
                 "ties; up to 8 values of each map",
       .mutants = {mutant("codes averaged as bytes", "attribute", {0, 2},
                          baking_another(&Baking::wide,
                                         [](Level, Picture16& p) {
                                           each_code(p, [](std::uint16_t& code) {
                                             code = static_cast<std::uint16_t>(code / 256 * 257);
                                           });
                                         })),
                   mutant("bytes in the other order", "attribute", {0, 2},
                          baking(&Baking::wide,
                                 [=](MapForm, Level n, BakeCaseOf<std::uint16_t> one,
                                     const MapBakerOf<std::uint16_t>& real) {
                                   each_code(one.picture, bytes_swapped);
                                   auto map = real(one, n);
                                   for (auto& value : map)
                                     for (std::uint16_t& code : value) bytes_swapped(code);
                                   return map;
                                 })),
                   mutant("what lies in the middle is rounded down", "attribute", {0, 2},
                          rounds_16_half_down()),
                   mutant("directions not made one unit long again", "attribute", {0, 3},
                          baking_another(&Baking::wide,
                                         [](Level, Picture16& p) {
                                           if (p.meaning == Meaning::normal) p.meaning = Meaning::linear;
                                         })),
                   mutant("the length lost, alpha in its place", "attribute", {0, 3},
                          baking_another(&Baking::wide,
                                         [](Level, Picture16& p) {
                                           if (p.meaning == Meaning::normal_and_length)
                                             p.meaning = Meaning::normal;
                                         })),
                   mutant("the border is black at level 4", "attribute", {4, 4},
                          baking_another(&Baking::wide,
                                         [](Level n, Picture16& p) {
                                           if (n == 4) p.border = {};
                                         }))}},
      needing({bakes_vertices_16, bakes_faces_16}), cases_of(wide_sample_case, &Baking::wide, 96));
}

// ---- Floats

using PictureFloat = PictureOf<float>;

constexpr Entry bakes_vertices_floats{"vertices of floats",
                                      [](const Functions& f) { return bool(f.baking.floats.vertices); }};
constexpr Entry bakes_faces_floats{"faces of floats",
                                   [](const Functions& f) { return bool(f.baking.floats.faces); }};

/// Changes each number of a map: change(number).
template <class Change>
std::function<void(Functions&)> changing_floats(Change change) {
  return baking(&Baking::floats,
                [=](MapForm, Level n, const BakeCaseOf<float>& one, const MapBakerOf<float>& real) {
                  auto map = real(one, n);
                  for (auto& value : map)
                    for (float& x : value) x = change(x);
                  return map;
                });
}

/// Rounds ties to the number that is further from 0.
std::function<void(Functions&)> rounds_ties_away() {
  return baking(&Baking::floats, [](MapForm form, Level n, const BakeCaseOf<float>& one,
                                    const MapBakerOf<float>& real) {
    const auto number = [](std::uint32_t bits) { return spec::bake::number<Rational>(slow::Binary32{bits}); };
    auto map = real(one, n);
    for (std::uint32_t k = 0; k < map.size(); ++k)
      for (std::size_t c = 0; c < 4; ++c) {
        const std::uint32_t bits = bits_of(map[k][c]);
        if ((bits & 0x7fffffff) >= 0x7f7fffff) continue;
        const Rational value = value_at<slow::Binary32>(form, one, n, k, c);
        if (2 * value == number(bits) + number(bits + 1)) map[k][c] = channel_of_bits<float>(bits + 1);
      }
    return map;
  });
}

/// Sets texels below 2^-53 of the greatest to 0, which sums in binary64 lose.
void without_small_ones(PictureFloat& p) {
  float most = 0;
  for (const auto& texel : p.texels)
    for (const float x : texel) most = std::max(most, std::fabs(x));
  for (auto& texel : p.texels)
    for (float& x : texel)
      if (std::fabs(x) < most * 0x1p-53f) x = 0;
}

Law texel_floats_law() {
  return on_cases(
      {.id = "attribute.bake_texel_floats",
       .says = "of textures of binary32 micro-vertices and faces have the exact number, rounded to nearest, "
               "ties to even, however large and small texels lie side by side",
       .source = std::string(cam_5) + "; IEEE 754, 4.3.1",
       .method = Method::sample,
       .subjects = {"attribute"},
       .tiers = {.fast = {0, 4}, .long_run = {0, 8}, .seconds = 0.5},
       .domain = "textures of up to 7x7 texels of binary32, all modes; ordinary numbers, 2^100 beside "
                 "2^-100, some that cancel, subnormals, ties, zeros of both signs, lone bright ones, any; up "
                 "to 8 values of each map",
       .mutants = {mutant("ties away from zero", "attribute", {0, 2}, rounds_ties_away()),
                   mutant("what is below 2^-126 is 0", "attribute", {0, 2}, changing_floats([](float x) {
                            return std::fabs(x) < 0x1p-126f ? std::copysign(0.0f, x) : x;
                          })),
                   mutant("small texels lost beside large ones", "attribute", {0, 2},
                          baking_another(&Baking::floats,
                                         [](Level, PictureFloat& p) { without_small_ones(p); })),
                   mutant("texels of 16 bits of fraction", "attribute", {0, 2},
                          baking_another(&Baking::floats,
                                         [](Level, PictureFloat& p) {
                                           for (auto& texel : p.texels)
                                             for (float& x : texel)
                                               x = channel_of_bits<float>(bits_of(x) & ~0x7fu);
                                         })),
                   mutant("0 keeps no sign", "attribute", {0, 4},
                          changing_floats([](float x) { return x == 0 ? 0.0f : x; })),
                   mutant("the border is 0 at level 4", "attribute", {4, 4},
                          baking_another(&Baking::floats,
                                         [](Level n, PictureFloat& p) {
                                           if (n == 4) p.border = {};
                                         }))}},
      needing({bakes_vertices_floats, bakes_faces_floats}), cases_of(float_sample_case, &Baking::floats, 20));
}

}  // namespace

std::vector<Law> bake_texel_laws() { return {texels16_law(), texel_floats_law()}; }

}  // namespace mmverify::proofs::attribute
