// The functions of a subject of topic attribute for baking from textures.
#pragma once

#include <bit>
#include <type_traits>

#include "proofs/engine/law.hpp"
#include "proofs/engine/value_set.hpp"
#include "spec/attribute/bake.hpp"
#include "spec/attribute/plan.hpp"

namespace mmverify::proofs::attribute {

using spec::Rational;
using spec::attribute::Filter;
using spec::attribute::Neighbours;
using spec::bake::Wrap;

/// A texel, or a value of a map.  Channel: std::uint8_t, std::uint16_t or float.
template <class Channel>
using RgbaOf = std::array<Channel, 4>;
using Rgba = RgbaOf<std::uint8_t>;

/// The bits of a channel.
template <class Channel>
constexpr std::uint32_t bits_of(Channel c) {
  if constexpr (std::is_same_v<Channel, float>)
    return std::bit_cast<std::uint32_t>(c);
  else
    return c;
}
template <class Channel>
constexpr Channel channel_of_bits(std::uint32_t bits) {
  if constexpr (std::is_same_v<Channel, float>)
    return std::bit_cast<float>(bits);
  else
    return static_cast<Channel>(bits);
}

/// The meaning of a picture's codes, which decides the average that is taken.  Alpha is linear in all of them.
enum class Meaning : std::uint8_t { linear, srgb, normal, normal_and_length };

/// Texel (x, y) at x + width y.
template <class Channel>
struct PictureOf {
  std::uint32_t width = 1, height = 1;
  std::vector<RgbaOf<Channel>> texels = {};
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  Filter filter = Filter::bilinear;
  Meaning meaning = Meaning::linear;
  RgbaOf<Channel> border{};
};
using Picture = PictureOf<std::uint8_t>;

/// The u, v of a base triangle's vertices: any three points.
using UvTriangle = std::array<float, 6>;

/// A texture and the triangle that is baked from it.
template <class Channel>
struct BakeCaseOf {
  PictureOf<Channel> picture;
  UvTriangle uv{};
};
using BakeCase = BakeCaseOf<std::uint8_t>;

enum class MapForm : std::uint8_t { faces, vertices };

/// The largest error and the mean square of a channel's error, as numbers from 0 to 1, or upper bounds of them.
struct ChannelError {
  Rational largest, square;
};

/// The input of a plan: the mesh, its highest level, and which triangle keeps its error bound at which level with
/// which edges decimated.
struct PlanCase {
  std::vector<Neighbours> neighbours;
  Level highest = 0;
  std::vector<bool> special;  ///< the triangle has a single value and needs no map
  std::function<bool(std::size_t triangle, Level, std::uint8_t decimated)> keeps;
};

struct PlannedTriangle {
  Level level = 0;
  std::uint8_t decimated = 0;
  bool kept = true;
};

/// The settings that a baker supports, and its tolerance in codes.
struct BakingSupport {
  Level max_level = 12;
  Set meanings = {}, filters = {}, wraps = {};
  bool same_wraps = false;
  std::uint32_t tolerance = 0;
};

/// A baker: the map of a case, or an empty map if it declines the case.
template <class Channel>
using MapBakerOf = std::function<std::vector<RgbaOf<Channel>>(const BakeCaseOf<Channel>&, Level)>;

/// Maps: vertices in W-minor order, faces on the curve.
template <class Channel>
struct Bakers {
  MapBakerOf<Channel> vertices = {}, faces = {};

  MapBakerOf<Channel>& of(MapForm form) { return form == MapForm::faces ? faces : vertices; }
  const MapBakerOf<Channel>& of(MapForm form) const { return form == MapForm::faces ? faces : vertices; }
};

/// The baking functions of a subject: 8 bits a channel, in `wide` 16, in `floats` binary32.
struct Baking {
  BakingSupport support = {};
  MapBakerOf<std::uint8_t> vertices = {}, faces = {};
  Bakers<std::uint16_t> wide = {};
  Bakers<float> floats = {};
  /// The exact mean of a channel over face `index`.
  std::function<Rational(const BakeCase&, Level, std::size_t channel, std::uint32_t index)> face_mean = {};
  /// The error of a map against the texture sampled bilinearly, or bounds at most `slack` above it.
  std::function<std::array<ChannelError, 4>(const BakeCase&, Level, MapForm, const std::vector<Rgba>&)>
      error = {};
  double slack = 0;
  /// Linear light at m / 510 in units of 2^-24, m in 0..510.
  std::function<std::uint32_t(std::uint32_t m)> light = {};
  std::function<std::vector<PlannedTriangle>(const PlanCase&)> plan = {};
};

}  // namespace mmverify::proofs::attribute
