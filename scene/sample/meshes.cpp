#include "scene/sample/meshes.hpp"

namespace mmverify::scene {
namespace {

constexpr std::array<Uv, 4> corners{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};  // of a picture, its foot first

/// The corners of one of the two leaves, starting at corner number `turn`; `mirrored` goes around the other
/// way.
std::array<Uv, 4> leaf(bool second, int turn, bool mirrored) {
  std::array<Uv, 4> uvs;
  for (int k = 0; k < 4; ++k) {
    const Uv& corner = corners[static_cast<std::size_t>((turn + (mirrored ? 4 - k : k)) % 4)];
    uvs[static_cast<std::size_t>(k)] = {(second ? 0.5f : 0.0f) + 0.5f * corner[0], corner[1]};
  }
  return uvs;
}

Position point(double x, double y, double z) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

}  // namespace

SampleMesh leaf_cards() {
  SampleMesh mesh;
  // Each leaf follows the last by the golden angle, with this cosine and sine, so that no two are above each
  // other.
  constexpr double c = -0.73736887807831963, s = 0.67549029426152362;
  double x = 1, z = 0;
  for (int k = 0; k < 24; ++k) {
    const double y = 0.2 + 0.04 * k, size = 0.42 - 0.012 * k, rise = 0.3 + 0.02 * k;
    const double aside_x = -z * size / 2, aside_z = x * size / 2;
    const auto at = [&](double out, double side) {
      return point(x * out + aside_x * side, y + out * rise, z * out + aside_z * side);
    };
    // The leaf's foot, corners 0 and 1 of the picture, is at the stalk.  Which corner of the card is there
    // differs from card to card, as in models whose cards were turned and mirrored.
    const std::array<Position, 4> card{at(0, -1), at(0, 1), at(size, 1), at(size, -1)};
    const int turn = k % 4;
    const bool mirrored = k % 3 == 1;
    std::array<Position, 4> turned;
    for (int i = 0; i < 4; ++i)
      turned[static_cast<std::size_t>(i)] =
          card[static_cast<std::size_t>((turn + (mirrored ? 4 - i : i)) % 4)];
    mesh.add_quad(turned, leaf(k % 5 == 4, turn, mirrored));
    const double next = x * c - z * s;
    z = x * s + z * c;
    x = next;
  }
  return mesh;
}

SampleMesh box(const Position& sizes) {
  SampleMesh mesh;
  const auto corner = [&](double x, double y, double z) {
    return point((x - 0.5) * sizes[0], y * sizes[1], (z - 0.5) * sizes[2]);
  };
  const auto side = [&](const Position& a, const Position& b, const Position& c, const Position& d) {
    mesh.add_quad({a, b, c, d}, {});
  };
  side(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
  side(corner(1, 0, 0), corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0));
  side(corner(1, 0, 1), corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1));
  side(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
  side(corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0), corner(0, 1, 0));
  mesh.uvs.clear();
  return mesh;
}

SampleMesh stalk() { return box({0.03f, 1.1f, 0.03f}); }

SampleMesh fence_panel() {
  SampleMesh mesh;
  for (int column = 0; column < 4; ++column) {
    const double left = -1 + 0.5 * column, right = left + 0.5;
    std::array<Uv, 4> uvs = corners;
    for (Uv& uv : uvs) uv[0] += static_cast<float>(column);
    mesh.add_quad({point(left, 0, 0), point(right, 0, 0), point(right, 1, 0), point(left, 1, 0)}, uvs);
  }
  return mesh;
}

SampleMesh lying_square(float half, float high, int cells) {
  SampleMesh mesh;
  const auto part = [&](int k) { return static_cast<float>(k) / static_cast<float>(cells); };
  const auto at = [&](int x, int y) {
    return Position{half * (2 * part(x) - 1), high, half * (2 * part(y) - 1)};
  };
  const auto uv = [&](int x, int y) { return Uv{part(x), part(y)}; };
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x)
      mesh.add_quad({at(x, y + 1), at(x + 1, y + 1), at(x + 1, y), at(x, y)},
                    {uv(x, y + 1), uv(x + 1, y + 1), uv(x + 1, y), uv(x, y)});
  return mesh;
}

SampleMesh flower_fan() {
  SampleMesh mesh;
  constexpr float r = 0.70710678f;
  constexpr Uv rim[]{{1, 0}, {r, -r}, {0, -1}, {-r, -r}, {-1, 0}, {-r, r}, {0, 1}, {r, r}, {1, 0}};
  mesh.positions.push_back({0, 0, 0});
  mesh.uvs.push_back({0.5f, 0.5f});
  for (const auto& [a, b] : rim) {
    mesh.positions.push_back({0.12f * a, 0.04f, 0.12f * b});
    mesh.uvs.push_back({0.5f + 0.5f * a, 0.5f + 0.5f * b});
  }
  return mesh;
}

SampleMesh tuft_strip() {
  SampleMesh mesh;
  // No blade reaches the part above the third height.
  for (const float up : {0.0f, 0.5f, 0.8125f, 1.0f}) {
    const float bend = 0.1f * up * up;
    for (const float side : {0.0f, 1.0f}) {
      mesh.positions.push_back({0.5f * side - 0.25f, 0.25f * up, bend});
      mesh.uvs.push_back({side, 1 - up});
      mesh.indices.push_back(static_cast<std::uint16_t>(mesh.indices.size()));
    }
  }
  return mesh;
}

}  // namespace mmverify::scene
