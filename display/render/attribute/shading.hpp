// The look of a surface: the Trowbridge-Reitz (GGX) model of glTF's metal and roughness.
#pragma once

#include <array>

namespace mmverify::render {

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b);
/// The vector at length 1.  Domain: not 0.
Vector unit(const Vector& a);

/// The attributes at a point: linear light, shares in [0, 1], and a normal of length 1.
struct Look {
  Vector colour{};
  double metallic = 0, roughness = 1, occlusion = 1;
  Vector normal{0, 0, 1};
};

/// The light that reaches the eye if light 1 comes from `to_light`: f(l, v) (n l).
///   f = (1 - F)(1 - metallic) colour/pi + D V F,  h = unit(l + v)
///   D = a^2 / (pi ((n h)^2 (a^2 - 1) + 1)^2),  a = roughness^2, roughness from 0.045 up
///   V = 0.5 / ((n l) sqrt((n v)^2 (1 - a^2) + a^2) + (n v) sqrt((n l)^2 (1 - a^2) + a^2))
///   F = f0 + (1 - f0)(1 - v h)^5,  f0 = 0.04 (1 - metallic) + colour metallic
/// It is 0 if the light is behind the surface; n v counts as at least 1e-4.
/// Domain: vectors one unit long, shares and colours in [0, 1].
/// Source: Walter et al., Microfacet Models for Refraction (2007); Heitz (2014), 5.3; glTF 2.0, appendix B.
Vector reflected(const Look& look, const Vector& to_eye, const Vector& to_light);

/// srgb_code() clamps linear light to [0, 1] and rounds it to an sRGB code.  srgb_light() is the linear light
/// of an encoded share in [0, 1].
unsigned char srgb_code(double light);
double srgb_light(double encoded);

}  // namespace mmverify::render
