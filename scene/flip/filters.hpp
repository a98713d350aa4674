// The filters of FLIP, each a product of one along x and one along y.
#pragma once

#include <cstddef>
#include <vector>

namespace mmverify::flip::detail {

/// An even or odd filter: weight k is for the texels at distance k.
using Half = std::vector<float>;

/// Contrast sensitivity of the eye, as a sum of Gaussians over the distance d in degrees:
///   g(d) = a sqrt(pi / b) e^(-pi^2 d^2 / b)
///   luminance  a = 1, b = 0.0047;  red-green  a = 1, b = 0.0053;
///   blue-yellow  a = 34.1, b = 0.04 and a = 13.5, b = 0.025
/// The weights over all texels of the plane sum to 1.  Each of the two filters of blue-yellow is a product by
/// itself, of the square root of its factor; only the sum of their products is 1.
/// Radius: three standard deviations of the widest, ceil(3 sqrt(0.04 / (2 pi^2)) pixels per degree).
/// Source: the paper, 4.1.1 and table 1.
struct SpatialFilters {
  std::size_t radius;
  Half luminance, red_green, blue_yellow[2];
};
SpatialFilters spatial_filters(double pixels_per_degree);

/// A Gaussian of the standard deviation s = 0.082 / 2 pixels per degree, and its derivatives of both orders:
///   smooth e^(-k^2/2s^2), of sum 1;  edge k times that, right minus left, each side of sum 1;
///   point (k^2/s^2 - 1) times that, positive weights of sum 1, negative ones of sum -1
/// Radius: ceil(3 s).  Source: the paper, 4.2.
struct FeatureFilters {
  std::size_t radius;
  Half smooth, edge, point;
};
FeatureFilters feature_filters(double pixels_per_degree);

}  // namespace mmverify::flip::detail
