#include "proofs/traverse/rays/conformance.hpp"

#include <fmt/format.h>

#include "proofs/pipe/lines.hpp"
#include "proofs/points/cells.hpp"

namespace mmverify::proofs::traverse {
namespace {

using points::Cells;
using points::GridPoint;
using points::Row;
using spec::micromap::State;
using spec::traverse::Outcome;

/// Sixteenths of a micro-triangle's side, in which points and their surroundings are counted.
constexpr std::int64_t unit = 16;

GridPoint point(std::int64_t u, std::int64_t v, Level n) {
  const unsigned bits = n + 4;
  return {spec::Fixed64::dyadic(u, bits), spec::Fixed64::dyadic(v, bits)};
}

/// Between the three directions of the grid's lines there are six sectors; one step into each of them.
constexpr std::array<std::array<std::int64_t, 2>, 6> sectors{
    {{1, 1}, {-1, 2}, {-2, 1}, {-1, -1}, {1, -2}, {2, -1}}};

std::vector<std::uint32_t> touching(std::int64_t u, std::int64_t v, Level n) {
  std::vector<std::uint32_t> all;
  const std::int64_t most = unit << n;
  for (const auto& [du, dv] : sectors)
    if (u + du >= 0 && v + dv >= 0 && u + du + v + dv <= most)
      all.push_back(spec::index::reference(point(u + du, v + dv, n), n));
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

float coordinate(std::int64_t k, Level n) { return static_cast<float>(k) / static_cast<float>(unit << n); }

/// The least power of two of parts of a side in which a point is that far from all lines, and its number of parts along
/// u and v within an upright micro-triangle.
struct Inside {
  std::int64_t parts = 4, at = 1;
};
Inside inside_of(double distance) {
  Inside inside;
  // The nearest to a third from below, of ever finer parts: 1/4, 5/16, 21/64, ...; w's remainder is then above a third.
  while (static_cast<double>(inside.at) < distance * static_cast<double>(inside.parts)) {
    inside.parts *= 4;
    inside.at = 4 * inside.at + 1;
  }
  return inside;
}

const char* name_of(Kind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

const char* outcome_name(Outcome outcome) {
  return outcome == Outcome::ignored ? "ignored" : outcome == Outcome::opaque ? "opaque" : "any-hit";
}

}  // namespace

State ray_state(std::uint32_t index) {
  // Source: the finaliser of MurmurHash3, 32 bits.
  std::uint32_t x = (index >> 2) + 0x9E3779B9u;
  x = (x ^ x >> 16) * 0x85EBCA6Bu;
  x = (x ^ x >> 13) * 0xC2B2AE35u;
  return static_cast<State>(((x ^ x >> 16) ^ index) & 3);
}

std::vector<std::uint8_t> ray_map(Level level) {
  const std::uint32_t count = std::uint32_t{1} << (2 * level);
  std::vector<std::uint8_t> map((count + 3) / 4);
  for (std::uint32_t k = 0; k < count; ++k)
    map[k / 4] = static_cast<std::uint8_t>(map[k / 4] | static_cast<unsigned>(ray_state(k)) << (2 * (k % 4)));
  return map;
}

Outcome ray_outcome(State state) {
  return state == State::T ? Outcome::ignored : state == State::O ? Outcome::opaque : Outcome::non_opaque;
}

std::uint64_t conformance_rays(Level level, double distance) {
  return distance > 0 ? points::triangle_count(level) : points::cell_count(level);
}

void each_conformance_ray(Level level, double distance,
                          const std::function<bool(const ConformanceRay&)>& visit) {
  if (level > finest_ray_level || !(distance >= 0 && distance <= most_distance))
    throw std::invalid_argument("each_conformance_ray: level or distance beyond its domain");
  const Inside inside = inside_of(distance);
  const Cells cells(level);
  bool open = true;
  cells.rows(0, cells.size(), [&](const Row& row) {
    for (std::uint64_t t = 0; t < row.count && open; ++t) {
      ConformanceRay ray;
      ray.kind = row.kind(t);
      if (distance > 0 && ray.kind != Kind::interior) continue;
      // Quarters of a side, four sixteenths each.
      const std::int64_t u = 4 * (row.ku + static_cast<std::int64_t>(t) * row.stride), v = 4 * row.kv;
      ray.index = spec::index::reference(point(u, v, level), level);
      ray.touching = touching(u, v, level);
      ray.on_outline = u == 0 || v == 0 || u + v == unit << level;
      ray.u = coordinate(u, level);
      ray.v = coordinate(v, level);
      if (distance > 0.25) {
        const bool inverted = row.kv % 4 == 3;
        const double parts = static_cast<double>(inside.parts << level);
        const auto moved = [&](std::int64_t k) {
          const std::int64_t at = k / unit * inside.parts + (inverted ? inside.parts - inside.at : inside.at);
          return static_cast<float>(static_cast<double>(at) / parts);
        };
        ray.u = moved(u);
        ray.v = moved(v);
      }
      open = visit(ray);
    }
  });
}

bool write_conformance_rays(Level level, double distance, std::FILE* out) {
  pipe::Written written(out);
  bool open = written.line(fmt::format("{}rays level {} cases {} distance {}", pipe::heading_begins, level,
                                       conformance_rays(level, distance), distance));
  open = open && written.line("# triangle 0 0 0  1 0 0  0 1 0");
  std::string map;
  for (const std::uint8_t byte : ray_map(level)) map += fmt::format("{:02x}", byte);
  open = open && written.line("# map 4-state " + map);
  open =
      open && written.line(
                  "# MISS allowed: on the triangle's outline, which a correct ray test may miss; else never");
  open = open && written.line("# CASE KIND OX OY OZ DX DY DZ T U V INDEX STATE OUTCOME TOUCHING MISS");
  std::uint64_t number = 0;
  each_conformance_ray(level, distance, [&](const ConformanceRay& ray) {
    const State state = ray_state(ray.index);
    open =
        open && written.line(fmt::format("{} {} {:a} {:a} 1 0 0 -1 1 {:a} {:a} {} {} {} {} {}", number++,
                                         name_of(ray.kind), ray.u, ray.v, ray.u, ray.v, ray.index,
                                         spec::micromap::name_of(state), outcome_name(ray_outcome(state)),
                                         fmt::join(ray.touching, ","), ray.on_outline ? "allowed" : "never"));
    return open;
  });
  return written.end();
}

}  // namespace mmverify::proofs::traverse
