// Colour spaces of FLIP, and its constants.
#pragma once

#include <array>
#include <cmath>

namespace mmverify::flip::detail {

using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

/// Linear light of an sRGB code value in [0, 1].  Source: IEC 61966-2-1.
inline double linear_of_srgb(double c) {
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Linear RGB to XYZ: sRGB's primaries and D65 as fractions of whole numbers.
/// Source: image-engineering.de, technote 958, which FLIP's authors name.
inline constexpr Matrix xyz_of_rgb{{{10135552. / 24577794, 8788810. / 24577794, 4435075. / 24577794},
                                    {2613072. / 12288897, 8788810. / 12288897, 887015. / 12288897},
                                    {1425312. / 73733382, 8788810. / 73733382, 70074185. / 73733382}}};

inline constexpr Vector times(const Matrix& m, const Vector& v) {
  Vector r{};
  for (std::size_t i = 0; i < 3; ++i) r[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return r;
}

/// XYZ of white, rgb (1, 1, 1).
inline constexpr Vector white = times(xyz_of_rgb, {1, 1, 1});

/// Linear RGB to X, Y and Z of white 1.
inline constexpr Matrix relative_xyz_of_rgb = [] {
  Matrix m = xyz_of_rgb;
  for (std::size_t i = 0; i < 3; ++i)
    for (double& e : m[i]) e /= white[i];
  return m;
}();

/// The inverse of a matrix, by cofactors.
inline constexpr Matrix inverse(const Matrix& m) {
  const auto cofactor = [&m](std::size_t i, std::size_t j) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  const double determinant = m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  Matrix r{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r[i][j] = cofactor(j, i) / determinant;
  return r;
}
inline constexpr Matrix rgb_of_relative_xyz = inverse(relative_xyz_of_rgb);

/// The bound of CIE L*a*b*: its curve is linear below the third power of lab_delta.
inline constexpr double lab_delta = 6. / 29;
inline double lab_f(double t) {
  return t > lab_delta * lab_delta * lab_delta ? std::cbrt(t) : t / (3 * lab_delta * lab_delta) + 4. / 29;
}

/// L*, and a* and b* times L*/100: colours fade with the light (Hunt).
inline Vector hunt_lab(const Vector& rgb) {
  const Vector xyz = times(relative_xyz_of_rgb, rgb);
  const double x = lab_f(xyz[0]), y = lab_f(xyz[1]), z = lab_f(xyz[2]);
  const double l = 116 * y - 16;
  return {l, l / 100 * 500 * (x - y), l / 100 * 200 * (y - z)};
}

/// HyAB: |difference of L*| + the length of the difference of (a*, b*).
inline double hyab(const Vector& a, const Vector& b) {
  return std::abs(a[0] - b[0]) + std::sqrt((a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

// Source: the paper, 4.1 and 4.2: exponents q_c and q_f, and the point (p_c of the greatest difference, p_t) at which the
// line that maps differences to [0, 1] has its bend.
inline constexpr double q_c = 0.7, p_c = 0.4, p_t = 0.95, q_f = 0.5;
/// The width in degrees of an edge or a point, as people detect them.
inline constexpr double feature_width = 0.082;

/// The greatest difference of two colours of sRGB, that of green and blue, to the power of q_c.
inline double greatest_difference() { return std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), q_c); }

}  // namespace mmverify::flip::detail
