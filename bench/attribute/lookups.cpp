// The times of indices, triplets and values, one by one and in batches.
#include <random>

#include "bench/attribute/bench.hpp"
#include "bench/attribute/obvious.hpp"
#include "bench/attribute/points.hpp"
#include "bench/rounds.hpp"
#include "impl/attribute/lookup.hpp"

namespace mmverify::bench {
namespace {

namespace fast = impl::attribute;
using fast::VertexOrder;
using Words = std::vector<std::uint32_t>;

/// The inputs of all ways, and room for their answers.
struct Room {
  std::uint32_t level;
  FloatPoints points;
  Words i, j, index, out, x0, x1, x2;
  Words map, texture;  ///< empty above highest_map

  fast::TripletSpans triplets() { return {x0, x1, x2}; }
  SquareTexture square() const { return {texture, level}; }
};

Room room_of(std::uint32_t level, const AttributeBenchOptions& o) {
  std::mt19937_64 random(o.seed + level);
  Room room{level, uniform_points(points_timed, random), {}, {}, {}, {}, {}, {}, {}, {}, {}};
  for (std::size_t k = 0; k < points_timed; ++k) {
    const fast::Vertex x =
        fast::corners_of(fast::locate(room.points.u[k], room.points.v[k], level).at)[k % 3];
    room.i.push_back(x.i);
    room.j.push_back(x.j);
    room.index.push_back(static_cast<std::uint32_t>(random() % fast::vertex_count(level)));
  }
  for (Words* w : {&room.out, &room.x0, &room.x1, &room.x2}) w->resize(points_timed);
  if (level > highest_map) return room;
  room.map.resize(fast::vertex_count(level));
  room.texture.resize(std::size_t{1} << 2 * level);
  for (Words* w : {&room.map, &room.texture})
    for (std::uint32_t& x : *w) x = static_cast<std::uint32_t>(random());
  return room;
}

/// Calls f(k) for every point.
template <class F>
Work one_by_one(F f) {
  return {points_timed, [f] {
            for (std::size_t k = 0; k < points_timed; ++k) f(k);
          }};
}

template <VertexOrder order>
void add_order(const char* name, Room& r, std::vector<std::string>& names, std::vector<Work>& works) {
  Room* const room = &r;
  const std::uint32_t n = r.level;
  names.push_back(name);
  works.push_back(one_by_one(
      [=](std::size_t k) { room->out[k] = fast::vertex_index(order, room->i[k], room->j[k], n); }));
  works.push_back(one_by_one([=](std::size_t k) {
    const fast::Vertex x = fast::vertex_at(order, room->index[k], n);
    room->x0[k] = x.i;
    room->x1[k] = x.j;
  }));
  works.push_back(one_by_one([=](std::size_t k) {
    const auto x = fast::triplet(order, room->points.u[k], room->points.v[k], n);
    room->x0[k] = x[0];
    room->x1[k] = x[1];
    room->x2[k] = x[2];
  }));
  if (!r.map.empty())
    works.push_back(one_by_one([=](std::size_t k) {
      room->out[k] = fast::interpolated_rgba8(order, room->map, room->points.u[k], room->points.v[k], n);
    }));
  names.push_back(std::string(name) + ", batched");
  works.push_back({points_timed, [=] { fast::vertex_index(order, room->i, room->j, n, room->out); }});
  works.push_back({points_timed, [=] { fast::vertex_at(order, room->index, n, {room->x0, room->x1}); }});
  works.push_back(
      {points_timed, [=] { fast::triplets(order, room->points.u, room->points.v, n, room->triplets()); }});
  if (!r.map.empty())
    works.push_back(
        {points_timed,
         [=] { fast::interpolated_rgba8(order, room->map, room->points.u, room->points.v, n, room->out); }});
}

AttributeLookupLevel lookups_of(Room& r, std::size_t rounds) {
  Room* const room = &r;
  const std::uint32_t n = r.level;
  const bool maps = !r.map.empty();
  std::vector<Work> works{one_by_one([=](std::size_t k) {
    const auto x = figure_4_triplet(room->points.u[k], room->points.v[k], n);
    room->x0[k] = x[0];
    room->x1[k] = x[1];
    room->x2[k] = x[2];
  })};
  if (maps) {
    works.push_back(one_by_one([=](std::size_t k) {
      room->out[k] = bilinear_rgba8(room->square(), room->points.u[k], room->points.v[k]);
    }));
    works.push_back(
        {points_timed, [=] { bilinear_rgba8(room->square(), room->points.u, room->points.v, room->out); }});
  }
  const std::size_t before = works.size(), each = maps ? 4 : 3;
  std::vector<std::string> names;
  add_order<VertexOrder::w_minor>("W-minor", r, names, works);
  add_order<VertexOrder::u_major>("U-major", r, names, works);
  add_order<VertexOrder::bird>("Bird", r, names, works);
  const RoundTimes times = times_in_rounds(works, rounds);
  AttributeLookupLevel level{n, median(times[0]), {}, {}, {}};
  if (maps) {
    level.bilinear_ns = median(times[1]);
    level.bilinear_simd_ns = median(times[2]);
  }
  for (std::size_t o = 0; o < names.size(); ++o) {
    const std::size_t at = before + each * o;
    AttributeOrderTimes of{names[o],
                           median(times[at]),
                           median(times[at + 1]),
                           median(times[at + 2]),
                           median_ratio(times[0], times[at + 2]),
                           {},
                           {}};
    if (maps) {
      of.lookup_ns = median(times[at + 3]);
      of.lookup_to_bilinear = median_ratio(times[at + 3], times[o % 2 == 0 ? 1 : 2]);
    }
    level.orders.push_back(of);
  }
  return level;
}

}  // namespace

std::vector<AttributeLookupLevel> attribute_lookups(const AttributeBenchOptions& o) {
  std::vector<AttributeLookupLevel> levels;
  for (std::uint32_t level = o.first; level <= o.last; ++level) {
    if (o.progress) o.progress("lookups at level " + std::to_string(level));
    Room room = room_of(level, o);
    levels.push_back(lookups_of(room, o.rounds));
  }
  return levels;
}

}  // namespace mmverify::bench
