#include "proofs/bake/subject.hpp"

#include <type_traits>

#include "impl/bake/triangles.hpp"
#include "proofs/bake/mesh/mesh_baker.hpp"
#include "proofs/bake/truth/exact_texture.hpp"
#include "proofs/bake/truth/truth.hpp"
#include "proofs/points/narrow.hpp"

namespace mmverify::proofs::bake {
namespace {

namespace fast = mmverify::impl::bake;

std::uint32_t count_at(Level n) { return std::uint32_t{1} << 2 * n; }

Baked in_format(std::vector<State> states, Format format) {
  if (format == Format::two_state)
    for (State& s : states) s = spec::micromap::force2(s);
  return {std::move(states)};
}

/// A baker of 4-state maps.
template <class Map>
Functions map_by_map(Map map) {
  Functions functions;
  functions.bake = [map](const Case& one, Level n, Format format) -> std::optional<Baked> {
    return in_format(map(one, n), format);
  };
  return functions;
}

Functions specified() {
  Functions functions = map_by_map(true_map);
  functions.centroid = true;
  functions.support.moving = true;
  return functions;
}

// ---- impl/bake

static_assert(static_cast<int>(fast::Wrap::mirrored_repeat) == static_cast<int>(Wrap::mirrored_repeat) &&
              static_cast<int>(fast::Wrap::clamp_to_border) == static_cast<int>(Wrap::clamp_to_border) &&
              static_cast<int>(fast::Wrap::mirror_once) == static_cast<int>(Wrap::mirror_once));

template <class Stored>
Stored stored_number(std::uint32_t bits) {
  if constexpr (std::is_same_v<Stored, float>)
    return std::bit_cast<float>(bits);
  else
    return static_cast<Stored>(bits);
}

template <class Stored>
void bake_into(const Case& one, Level n, std::span<std::uint8_t> map, std::span<const fast::Box> changed) {
  std::vector<Stored> alpha(one.alpha.size());
  std::transform(one.alpha.begin(), one.alpha.end(), alpha.begin(), stored_number<Stored>);
  std::vector<fast::Texels> mips;
  std::size_t from = 0;
  for (std::uint32_t k = 0; k < one.mips; ++k) {
    const std::uint32_t width = std::max(1u, one.width >> k), height = std::max(1u, one.height >> k);
    mips.push_back(fast::TexelView<Stored>{alpha.data() + from, width, height, width});
    from += std::size_t{width} * height;
  }
  fast::AlphaMode mode = fast::Blend{};
  if (!one.blend) mode = fast::Cutoff{one.cutoff.numerator, one.cutoff.denominator};
  const fast::TriangleBaker baker(
      mips, mode,
      {static_cast<fast::Wrap>(one.wrap_u),
       static_cast<fast::Wrap>(one.wrap_v),
       one.filter == Filter::nearest ? fast::Filter::nearest : fast::Filter::bilinear,
       static_cast<float>(stored_number<Stored>(one.border)),
       {one.factor, one.vertex_factor},
       one.margin});
  const fast::BaseTriangle uv{{{one.uv[0], one.uv[1]}, {one.uv[2], one.uv[3]}, {one.uv[4], one.uv[5]}}};
  const fast::MovingTriangle moving{uv, one.travel[0], one.travel[1]};
  if (!changed.empty())
    baker.rebake(moving, n, map, changed);
  else if (one.travel == std::array<float, 2>{})
    baker.bake(uv, n, map);
  else
    baker.bake_moving(moving, n, map);
}

/// A case with a change is baked as it was before, and then brought up to date.
template <class Stored>
std::optional<Baked> baked_from(const Case& one, Level n, Format format) {
  std::vector<std::uint8_t> map((count_at(n) + 3) / 4);
  std::vector<fast::Box> changed;
  for (const auto& [x, y, width, height] : one.change.boxes) changed.push_back({x, y, width, height});
  if (!changed.empty()) bake_into<Stored>(before_change(one), n, map, {});
  bake_into<Stored>(one, n, map, changed);
  std::vector<State> states(count_at(n));
  for (std::size_t k = 0; k < states.size(); ++k)
    states[k] = static_cast<State>(map[k / 4] >> 2 * (k % 4) & 3);
  return in_format(std::move(states), format);
}

std::optional<Baked> baked_by_impl(const Case& one, Level n, Format format) {
  const auto small = [](float x) { return x > -0x1p20f && x < 0x1p20f; };
  if (n > fast::max_bake_level || !std::all_of(one.uv.begin(), one.uv.end(), small) || !small(one.margin) ||
      !std::all_of(one.travel.begin(), one.travel.end(), small))
    return std::nullopt;
  switch (one.texel) {
    case Texel::unorm16: return baked_from<std::uint16_t>(one, n, format);
    case Texel::float32: return baked_from<float>(one, n, format);
    case Texel::unorm8: break;
  }
  return baked_from<std::uint8_t>(one, n, format);
}

Functions this_projects() {
  Functions functions{baked_by_impl, true, {}};
  functions.support.moving = functions.support.updates = true;
  return functions;
}

// ---- Bakers that sample

using CornerWeights = std::array<int, 3>;

/// Whether alpha is opaque at a place given by its weights of a micro-triangle's corners, over their sum.
template <class Q, class Stored>
bool opaque_at(const Case& one, const spec::bake::TextureOf<Stored>& texture,
               const spec::bake::Polygon<Q>& corners, const CornerWeights& weights) {
  const Q share = spec::bake::fraction<Q>(1, weights[0] + weights[1] + weights[2]);
  spec::bake::TexturePoint<Q> p{0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    p.x += corners[k].x * Q(weights[k]) * share;
    p.y += corners[k].y * Q(weights[k]) * share;
  }
  return with_mode<Q>(one, [&](const auto& mode) { return mode.opaque(spec::bake::alpha(texture, p)); });
}

/// O or T as the points say, where they agree; else the first one's unknown.
Functions sampled_at(const std::vector<CornerWeights>& points) {
  return map_by_map([points](const Case& one, Level n) {
    std::vector<State> states(count_at(n));
    with_textures(one, [&](const auto& mips) {
      for (std::uint32_t k = 0; k < states.size(); ++k)
        states[k] = in_smallest([&]<class Q>() {
          const auto corners = spec::bake::micro_triangle(base_triangle<Q>(one), n, k, one.width, one.height);
          const bool first = opaque_at<Q>(one, mips.front(), corners, points.front());
          for (const CornerWeights& weights : points)
            if (opaque_at<Q>(one, mips.front(), corners, weights) != first)
              return first ? State::UO : State::UT;
          return first ? State::O : State::T;
        });
    });
    return states;
  });
}

/// With a baker of meshes, whose arrays that builder makes.
Functions of_meshes(Functions functions, const char* builder) {
  functions.bake_mesh = mesh_baker_of(functions, builder);
  return functions;
}

BakeSubjectPtr subject(const char* name, const char* about, Functions functions) {
  return std::make_shared<BakeSubject>(name, about, std::move(functions));
}

}  // namespace

const std::vector<BakeSubjectPtr>& built_in_subjects() {
  static const std::vector<BakeSubjectPtr> all{
      subject("bake-spec", "the specification, micro-triangle by micro-triangle",
              of_meshes(specified(), "array-spec")),
      subject("bake", "this project's library", of_meshes(this_projects(), "array")),
      subject("centre-sample", "O or T as alpha at the centroid is; not conservative",
              sampled_at({{1, 1, 1}})),
      subject("corner-samples", "O or T where alpha at all three corners is; not conservative",
              sampled_at({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})),
  };
  return all;
}

Mutant spoiled(const char* name, const std::string& base, Levels levels, const Spoil& spoil) {
  return mutant(name, base, levels, [&](Functions& functions) {
    functions.bake = [spoil, real = functions.bake](const Case& one, Level n, Format format) {
      auto baked = real(one, n, Format::four_state);
      if (!baked) return baked;
      spoil(one, n, baked->states);
      return std::optional(in_format(std::move(baked->states), format));
    };
  });
}

namespace {

std::size_t bits_of(Format format) { return static_cast<std::size_t>(format); }

}  // namespace

std::size_t packed_bytes(Level n, Format format) {
  return ((std::size_t{1} << 2 * n) * bits_of(format) + 7) / 8;
}

std::vector<std::uint8_t> packed(const std::vector<State>& states, Format format) {
  const std::size_t bits = bits_of(format);
  std::vector<std::uint8_t> bytes((states.size() * bits + 7) / 8);
  for (std::size_t k = 0; k < states.size(); ++k)
    bytes[k * bits / 8] =
        static_cast<std::uint8_t>(bytes[k * bits / 8] | static_cast<unsigned>(states[k]) << k * bits % 8);
  return bytes;
}

Baked unpacked(std::span<const std::uint8_t> bytes, Level n, Format format) {
  const std::size_t bits = bits_of(format), count = std::size_t{1} << 2 * n;
  const auto state = [&](std::size_t k) { return bytes[k * bits / 8] >> k * bits % 8 & ((1u << bits) - 1); };
  Baked baked;
  for (std::size_t k = 0; k < count; ++k) baked.states.push_back(static_cast<State>(state(k)));
  for (std::size_t k = count; k * bits < 8 * bytes.size(); ++k) baked.padded = baked.padded && state(k) == 0;
  return baked;
}

}  // namespace mmverify::proofs::bake
