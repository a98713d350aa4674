// render/: a scene along a random path.  Without Embree all of it is skipped, and so said.
#include "display/render/scene/path.hpp"

#include <gtest/gtest.h>

#include <set>

#include "display/render/vectors.hpp"
#include "scene/read/load.hpp"
#include "scene/sample/scene.hpp"
#include "tests/render/needs_embree.hpp"

namespace {

using namespace mmverify;
using namespace mmverify::render;

/// The suite's own scene, ready for rays.
struct Own {
  scene::Bytes bytes = scene::sample_scene();
  scene::Scene scene = scene::load("sample", bytes);
  scene::Plan plan = scene::plan(scene);
  SceneWorld world = world_of(scene, scene::load_uses("sample", bytes), plan);
  Tracer tracer{world.world};
  TraceOptions trace{.width = 60, .height = 40};

  static const Own& get() {
    static const Own own;
    return own;
  }
  std::vector<CameraView> path(std::uint64_t seed, std::uint64_t cameras) const {
    std::vector<CameraView> all;
    for (std::uint64_t number = 1; number <= cameras; ++number)
      all.push_back(seen_on_path(world.world, tracer, trace, seed, number));
    return all;
  }
};

TEST(Path, EveryCameraMeetsAMap) {
  NEEDS_EMBREE;
  std::set<Point> from;
  for (const CameraView& seen : Own::get().path(7, 12)) {
    from.insert(seen.camera.from);
    const Counts& counts = seen.frame.counts;
    EXPECT_GT(counts.met, 0u) << seen.number;
    EXPECT_LE(counts.met, counts.rays + counts.shadow_rays);
    EXPECT_LE(counts.met, counts.planned) << "a ray has several candidates, or none";
    EXPECT_LT(seen.tries, most_tries);
  }
  EXPECT_EQ(from.size(), 12u);
}

TEST(Path, IsThatOfItsSeed) {
  NEEDS_EMBREE;
  const auto a = Own::get().path(1, 2), b = Own::get().path(1, 2), c = Own::get().path(2, 2);
  EXPECT_EQ(digest(a[1].frame), digest(b[1].frame));
  EXPECT_NE(digest(a[1].frame), digest(c[1].frame));
}

TEST(Path, HasTheSpreadOfAFigure) {
  const std::vector<double> values{2, 4, 4, 4, 5, 5, 7, 9};
  const Spread spread = spread_of(values);
  EXPECT_EQ(spread.mean, 5);
  EXPECT_EQ(spread.least, 2);
  EXPECT_EQ(spread.most, 9);
  EXPECT_EQ(spread.deviation, 2);
  EXPECT_EQ(spread_of({}).most, 0);
}

TEST(Path, SeesTheSameByAllForms) {
  NEEDS_EMBREE;
  const Own& own = Own::get();
  FormsOptions forms{.first = 0, .last = 4, .wanted = {std::begin(methods), std::end(methods)}};
  const Path path = along_path(own.scene, own.plan, own.world, own.tracer, forms, own.trace, 5, 3);
  ASSERT_EQ(path.cameras.size(), 3u);
  ASSERT_EQ(path.rows.size(), 3u + 4 * 5);
  EXPECT_FALSE(path.left_out.first);
  std::uint64_t met = 0;
  for (const CameraView& seen : path.cameras) met += seen.frame.counts.met;
  for (const PathRow& row : path.rows) {
    EXPECT_EQ(row.differing, 0u) << name_of(row.method);
    EXPECT_FALSE(row.first);
    EXPECT_EQ(row.frames, 3u);
    ASSERT_EQ(row.calls_a_ray.size(), 3u);
    ASSERT_EQ(row.times_texture.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_LE(row.calls_a_ray[k], calls_a_ray(path.cameras[k].frame.counts));
    EXPECT_EQ(row.pixels, 3u * 60 * 40);
    EXPECT_EQ(row.counts.met, met);
  }
  forms.memory = 1;
  const Path none = along_path(own.scene, own.plan, own.world, own.tracer, forms, own.trace, 5, 1);
  EXPECT_EQ(none.rows.size(), 3u) << "square maps and bitmask, which have no level";
  EXPECT_EQ(none.left_out.first, 0u);
}

/// The same maps, but for one thing.
class Wrong : public Opacity {
 public:
  enum class Thing { nothing, unknown_is_opaque, holes_are_opaque, corners_exchanged };
  Wrong(const Opacity& right, Thing thing) : right_(right), thing_(thing) {}
  std::optional<impl::micromap::State> at(std::uint32_t geometry, std::uint32_t triangle,
                                          const Barycentrics& b) const override {
    using impl::micromap::State;
    auto state =
        right_.at(geometry, triangle, thing_ == Thing::corners_exchanged ? Barycentrics{b.v, b.u} : b);
    if (!state) return state;
    if (thing_ == Thing::unknown_is_opaque && (*state == State::UT || *state == State::UO)) return State::O;
    if (thing_ == Thing::holes_are_opaque && *state == State::T) return State::O;
    return state;
  }
  std::uint64_t bytes() const override { return right_.bytes(); }

 private:
  const Opacity& right_;
  Thing thing_;
};

TEST(Path, SeesWhatIsWrong) {
  NEEDS_EMBREE;
  const Own& own = Own::get();
  const std::vector<CameraView> path = own.path(3, 3);
  const FormsOptions forms{.first = 3, .last = 3, .wanted = {Method::flat}};
  each_forms(own.scene, own.plan, own.world, forms, [&](const FormsOfMaps& maps) {
    using Thing = Wrong::Thing;
    for (const Thing thing :
         {Thing::nothing, Thing::unknown_is_opaque, Thing::holes_are_opaque, Thing::corners_exchanged}) {
      const PathRow row =
          held_against(path, own.tracer, own.trace, Wrong(*maps.forms.front().opacity, thing));
      EXPECT_EQ(row.differing != 0, thing != Thing::nothing) << static_cast<int>(thing);
      ASSERT_EQ(row.first.has_value(), thing != Thing::nothing);
      if (!row.first) continue;
      const CameraView& seen = path[row.first->camera - 1];
      const Pixel alone = own.tracer.pixel(seen.camera, nullptr, own.trace, row.first->x, row.first->y),
                  wrong = own.tracer.pixel(seen.camera,
                                           std::make_unique<Wrong>(*maps.forms.front().opacity, thing).get(),
                                           own.trace, row.first->x, row.first->y);
      EXPECT_FALSE(same(alone, wrong));
    }
  });
}

TEST(Path, NeedsATriangleWithAMap) {
  NEEDS_EMBREE;
  World world;
  Geometry bare;
  bare.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  bare.triangles = {{0, 1, 2}};
  world.geometries = {bare};
  world.meshes = {{0}};
  world.instances = {Instance{}};
  const Tracer tracer(world);
  EXPECT_THROW(seen_on_path(world, tracer, {.width = 4, .height = 4}, 1, 1), std::invalid_argument);
}

}  // namespace
