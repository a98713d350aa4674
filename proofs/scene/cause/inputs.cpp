#include "proofs/scene/cause/inputs.hpp"

#include "proofs/engine/interrupt.hpp"

namespace mmverify::proofs::scene {

Inputs inputs_of(const Judged& judged) {
  Inputs inputs{judged.maps.plan.surfaces, {}};
  for (const auto& triangle : judged.maps.plan.triangles) inputs.uvs.push_back(triangle.uvs);
  return inputs;
}

void stop_if_due(const Judged& judged) {
  if (interrupted()) throw Interrupted();
  if (judged.until && std::chrono::steady_clock::now() > *judged.until) throw OutOfTime();
}

namespace {

std::vector<States> baked(const Judged& judged, const Inputs& inputs,
                          const std::vector<std::size_t>& triangles, const std::vector<unsigned>& levels) {
  mmverify::scene::Plan plan;
  plan.surfaces = inputs.surfaces;
  for (const std::size_t k : triangles) {
    mmverify::scene::PlannedTriangle triangle;
    triangle.surface = judged.maps.plan.triangles[k].surface;
    triangle.uvs = inputs.uvs[k];
    plan.triangles.push_back(triangle);
  }
  mmverify::scene::BakeOptions options;
  options.two_state = judged.two_state;
  options.margin = judged.margin;
  options.done = [&judged](std::uint64_t) { stop_if_due(judged); };
  std::vector<States> all;
  for (const auto& map : mmverify::scene::bake(judged.scene, plan, levels, options).triangles)
    all.push_back(states_of(map));
  return all;
}

}  // namespace

std::vector<States> expected(const Judged& judged, const Inputs& inputs,
                             const std::vector<std::size_t>& triangles) {
  std::vector<unsigned> levels;
  for (const std::size_t k : triangles) levels.push_back(judged.maps.baked.triangles[k].level);
  return baked(judged, inputs, triangles, levels);
}

States expected_at(const Judged& judged, const Inputs& inputs, std::size_t triangle, Level n) {
  return baked(judged, inputs, {triangle}, {n}).front();
}

}  // namespace mmverify::proofs::scene
