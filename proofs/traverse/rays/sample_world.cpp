#include "proofs/traverse/rays/sample_world.hpp"

#include <cstring>

#include "display/render/bitmask.hpp"
#include "display/render/vectors.hpp"
#include "impl/bake/square/map.hpp"
#include "impl/bake/triangles.hpp"
#include "impl/micromap/append.hpp"

namespace mmverify::proofs::traverse {
namespace {

using impl::bake::TexturePoint;
using render::Geometry;
using render::Point;

constexpr std::uint32_t disc_side = 32, tiles_side = 8, gradient_side = 16;

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() { return state_ = render::mixed(state_); }
  /// A number in [low, high).
  float between(float low, float high) {
    return low + (high - low) * static_cast<float>(next() >> 40) * 0x1p-24f;
  }

 private:
  std::uint64_t state_;
};

/// The corners around a card, in order, at a random place and in a random direction.
std::array<Point, 4> card(Numbers& numbers, float half) {
  const auto within = [&](float size) {
    return Point{numbers.between(-size, size), numbers.between(-size, size), numbers.between(-size, size)};
  };
  const Point middle = within(1), a = render::times(render::unit(within(1)), half),
              b = render::times(render::unit(render::cross(a, within(1))), half);
  std::array<Point, 4> corners{};
  for (std::size_t k = 0; k < 3; ++k) {
    corners[0][k] = middle[k] - a[k] - b[k];
    corners[1][k] = middle[k] + a[k] - b[k];
    corners[2][k] = middle[k] + a[k] + b[k];
    corners[3][k] = middle[k] - a[k] + b[k];
  }
  return corners;
}

void add(Geometry& geometry, const std::array<Point, 4>& corners, const std::array<TexturePoint, 4>& uvs,
         const std::array<std::array<std::uint8_t, 3>, 2>& triangles) {
  const auto first = static_cast<std::uint32_t>(geometry.positions.size());
  geometry.positions.insert(geometry.positions.end(), corners.begin(), corners.end());
  geometry.uvs.insert(geometry.uvs.end(), uvs.begin(), uvs.end());
  for (const auto& t : triangles) geometry.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

}  // namespace

SampleWorld::SampleWorld() {
  add_textures();
  add_cards();
  add_maps();
  add_colours();
}

void SampleWorld::add_textures() {
  for (std::uint32_t y = 0; y < disc_side; ++y)
    for (std::uint32_t x = 0; x < disc_side; ++x) {
      const float r = std::sqrt((static_cast<float>(x) - 14.3f) * (static_cast<float>(x) - 14.3f) +
                                (static_cast<float>(y) - 16.9f) * (static_cast<float>(y) - 16.9f));
      disc_.push_back(static_cast<std::uint8_t>(std::clamp(60 * (12.5f - r), 0.0f, 255.0f)));
    }
  for (std::uint32_t k = 0; k < tiles_side * tiles_side; ++k)
    tiles_.push_back(static_cast<std::uint16_t>(render::mixed(k) % 3 == 0 ? 65535 : 9000));
  for (std::uint32_t k = 0; k < gradient_side * gradient_side; ++k)
    gradient_.push_back(static_cast<std::uint8_t>(std::clamp(
        40 * (static_cast<int>(k % gradient_side) - 4) + 7 * static_cast<int>(k / gradient_side), 0, 255)));
  using namespace impl::bake;
  Sampling clamped, mirrored;
  clamped.u = clamped.v = Wrap::clamp_to_edge;
  mirrored.u = Wrap::mirrored_repeat;
  mirrored.filter = Filter::nearest;
  mirrored.factors = {0.8f, 1};
  world_.surfaces.emplace_back(Texels(TexelView<std::uint8_t>{disc_.data(), disc_side, disc_side, disc_side}),
                               clamped, AlphaMode(Cutoff{1, 2}));
  world_.surfaces.emplace_back(
      Texels(TexelView<std::uint16_t>{tiles_.data(), tiles_side, tiles_side, tiles_side}), mirrored,
      AlphaMode(Mask{0.3f}));
  world_.surfaces.emplace_back(
      Texels(TexelView<std::uint8_t>{gradient_.data(), gradient_side, gradient_side, gradient_side}), clamped,
      AlphaMode(Blend{}));
}

void SampleWorld::add_cards() {
  Numbers numbers(22);
  world_.geometries.resize(4);
  squares_.places.resize(4);
  for (std::uint32_t g = 0; g < 3; ++g) {
    world_.geometries[g].surface = g;
    world_.geometries[g].colour = g;
  }
  world_.geometries[3].planned = false;
  world_.geometries[3].colour = 3;
  for (std::uint32_t k = 0; k < 14; ++k) {
    // Boxes of whole texels for square maps, whose y counts from the bottom, with corners (0,0), (1,0), (1,1), (0,1).
    const bool all_opaque = k == 3, all_transparent = k == 4;
    const impl::bake::Box box = all_opaque ? impl::bake::Box{13, 15, 3, 3}
                                : all_transparent
                                    ? impl::bake::Box{0, 0, 3, 3}
                                    : impl::bake::Box{k % 3, k % 2, disc_side - 2, disc_side - 1};
    const auto u = [&](std::uint32_t x) { return static_cast<float>(x) / disc_side; };
    const float left = u(box.x), right = u(box.x + box.width), top = u(box.y), bottom = u(box.y + box.height);
    const std::uint8_t turn = static_cast<std::uint8_t>(k % 3);
    const auto turned = [&](std::array<std::uint8_t, 3> t) {
      std::rotate(t.begin(), t.begin() + turn, t.end());
      return t;
    };
    add(world_.geometries[0], card(numbers, 0.45f),
        {{{left, bottom}, {right, bottom}, {right, top}, {left, top}}},
        {turned({0, 1, 3}), turned({2, 3, 1})});
    // Corner c of a half is vertex c - turn of its triangle.
    std::array<std::uint8_t, 3> order{};
    for (std::uint8_t c = 0; c < 3; ++c) order[c] = static_cast<std::uint8_t>((c + 3 - turn) % 3);
    squares_.places[0].push_back({k, impl::vq::Half::lower, order});
    squares_.places[0].push_back({k, impl::vq::Half::upper, order});
    const impl::bake::AlphaView view{disc_.data(), disc_side, disc_side, disc_side};
    impl::bake::square_map(view, box, {1, 2}, 16, squares_.vq2.emplace_back());
    impl::bake::square_map(view, box, {1, 2}, 32, squares_.vq4.emplace_back());
  }
  for (std::uint32_t g = 1; g < 3; ++g)
    for (int k = 0; k < 7; ++k) {
      std::array<TexturePoint, 4> uvs{};
      for (TexturePoint& uv : uvs)
        uv = {numbers.between(-1.2f, 1.7f) * (g == 1 ? 1.0f : 0.6f), numbers.between(-0.4f, 1.3f)};
      add(world_.geometries[g], card(numbers, 0.4f), uvs, {{{0, 1, 2}, {2, 3, 0}}});
    }
  Geometry& ground = world_.geometries[3];
  add(ground, {{{-4, -1.4f, -4}, {4, -1.4f, -4}, {4, -1.4f, 4}, {-4, -1.4f, 4}}}, {},
      {{{0, 1, 2}, {2, 3, 0}}});
  // Opaque cards among the others, so that some cards lie behind them, and may be met first.
  for (int k = 0; k < 4; ++k) add(ground, card(numbers, 0.3f), {}, {{{0, 1, 2}, {2, 3, 0}}});
  world_.meshes = {{0, 1, 2}, {3}, {0, 2}};
  world_.instances.push_back({0});
  world_.instances.push_back({1});
  world_.instances.push_back({2, {0, 0, -0.7f, 0, 0.9f, 0, 0.8f, 0, 0, 1.2f, 0.2f, -0.4f}});
  box_ = render::box_of(world_, true);
}

void SampleWorld::add_maps() {
  using namespace impl::micromap;
  std::vector<impl::bake::TriangleBaker> bakers;
  for (const render::Surface& surface : world_.surfaces)
    bakers.emplace_back(std::span(&surface.texels(), 1), surface.mode(), surface.sampling());
  for (Level level = 0; level <= finest_sample_level; ++level) {
    auto maps = std::make_unique<render::Micromaps>();
    maps->codes.resize(world_.geometries.size());
    for (std::size_t g = 0; g < 3; ++g) {
      const Geometry& geometry = world_.geometries[g];
      std::vector<Bytes> bytes;
      std::vector<PackedMap> packed;
      for (std::size_t t = 0; t < geometry.triangles.size(); ++t) {
        bytes.emplace_back(packed_bytes(micro_triangles(level), Format::four_state));
        bakers[*geometry.surface].bake(geometry.uv_of(t), level, bytes.back());
      }
      for (const Bytes& map : bytes) packed.push_back({level, Format::four_state, map});
      const impl::micromap::Geometry built = append(maps->array, packed, {});
      auto& codes = maps->codes[g];
      codes.resize(geometry.triangles.size());
      std::memcpy(codes.data(), built.indices.data(), built.indices.size());
    }
    auto& of_level = opacities_.emplace_back();
    for (const render::Method method : render::methods)
      of_level.push_back(method == render::Method::texture   ? nullptr
                         : render::has_levels(method)        ? render::opacity_of(method, *maps)
                         : level != 0                        ? nullptr
                         : method == render::Method::bitmask ? render::bitmask_of(world_, 4)
                                                             : render::opacity_of(method, squares_));
    maps_.push_back(std::move(maps));
  }
}

void SampleWorld::add_colours() {
  std::uint64_t number = 0;
  for (std::uint32_t g = 0; g < 3; ++g) {
    std::vector<std::uint32_t> maps;
    for (std::size_t t = 0; t < world_.geometries[g].triangles.size(); ++t) {
      std::array<std::uint32_t, 16> map{};
      for (std::uint32_t& value : map) value = static_cast<std::uint32_t>(render::mixed(++number));
      maps.push_back(colours_.add(map));
    }
    colours_.give(g, std::move(maps));
  }
}

const render::Opacity* SampleWorld::opacity(render::Method method, unsigned level) const {
  return opacities_.at(render::has_levels(method) ? level : 0)[static_cast<std::size_t>(method)].get();
}

const render::Tracer& SampleWorld::tracer() const {
  static const render::Tracer tracer(get().world_);
  return tracer;
}

const SampleWorld& SampleWorld::get() {
  static const SampleWorld world;
  return world;
}

}  // namespace mmverify::proofs::traverse
