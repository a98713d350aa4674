#include "display/render/attribute/shading.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mmverify::render {

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector unit(const Vector& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

Vector reflected(const Look& look, const Vector& to_eye, const Vector& to_light) {
  const Vector& n = look.normal;
  const double nl = dot(n, to_light), nv = std::max(1e-4, dot(n, to_eye));
  if (!(nl > 0)) return {};
  const Vector sum{to_eye[0] + to_light[0], to_eye[1] + to_light[1], to_eye[2] + to_light[2]};
  if (!(dot(sum, sum) > 1e-12)) return {};
  const Vector h = unit(sum);
  const double nh = std::clamp(dot(n, h), 0.0, 1.0), vh = std::clamp(dot(to_eye, h), 0.0, 1.0);
  const double rough = std::max(0.045, look.roughness), a2 = std::pow(rough, 4);
  const double under = nh * nh * (a2 - 1) + 1;
  const double spread = a2 / (std::numbers::pi * under * under);
  const double seen =
      0.5 / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
  const double grazing = std::pow(1 - vh, 5);
  Vector light{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double f0 = 0.04 * (1 - look.metallic) + look.colour[c] * look.metallic;
    const double mirrored = f0 + (1 - f0) * grazing;
    light[c] = nl * ((1 - mirrored) * (1 - look.metallic) * look.colour[c] / std::numbers::pi +
                     spread * seen * mirrored);
  }
  return light;
}

unsigned char srgb_code(double light) {
  const double x = std::clamp(light, 0.0, 1.0);
  const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return static_cast<unsigned char>(std::floor(255 * encoded + 0.5));
}

double srgb_light(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace mmverify::render
