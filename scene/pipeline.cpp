#include "scene/pipeline.hpp"

#include <chrono>
#include <stdexcept>

#include "scene/validate/issues.hpp"
#include "scene/validate/micromaps.hpp"
#include "scene/write/glb.hpp"

namespace mmverify::scene {

SceneMicromaps make_micromaps(const Scene& scene, const PipelineOptions& options) {
  SceneMicromaps made;
  made.plan = plan(scene, options.level_limit, VaryingAlpha::planned, options.moving);
  made.levels = levels(made.plan, options.levels);
  const bool go_on = !options.planned || options.planned(made.plan, made.levels);
  if (!go_on || made.plan.triangles.empty()) return made;
  const auto start = std::chrono::steady_clock::now();
  made.baked = bake(scene, made.plan, made.levels.of, options.bake);
  made.bake_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  made.arrays = arrays(made.plan, made.baked);
  made.pairs = pairs(scene, made.plan);
  made.squares =
      square_maps(scene, made.plan, made.pairs, {options.bake.threads, false, options.bake.margin, {}});
  return made;
}

Sizes sizes(const Scene& scene, const Plan& plan, const Baked& baked, const SceneArrays& arrays,
            unsigned threads) {
  return {footprint(scene, plan, arrays, threads), any_hit_shares(scene, plan, baked)};
}

Sizes sizes_at_level(const Scene& scene, const Plan& plan, unsigned level, const BakeOptions& options) {
  const std::vector<unsigned> of(plan.triangles.size(), level);
  const Baked baked = bake(scene, plan, of, options);
  return sizes(scene, plan, baked, arrays(plan, baked), options.threads);
}

std::uint64_t map_bytes_at_level(const Plan& plan, unsigned level) {
  return impl::micromap::packed_bytes(impl::micromap::micro_triangles(level),
                                      impl::micromap::Format::four_state) *
         plan.triangles.size();
}

Bytes with_micromaps(const std::string& file, std::optional<std::span<const unsigned char>> bytes,
                     const Scene& scene, const Plan& plan, const SceneArrays& arrays, const std::string& name,
                     const BakeSettings& settings) {
  std::vector<PrimitiveMicromaps> primitives;
  for (std::size_t k = 0; k < arrays.primitives.size(); ++k) {
    const Primitive& primitive = scene.primitives[plan.primitives[k].primitive];
    primitives.push_back(
        {primitive.mesh, primitive.number, 0, arrays.encoding, arrays.primitives[k].geometry.indices, 0,
         "{\"" + std::string(bake_record_name) + "\":" + bake_record(scene, primitive, settings) + "}"});
  }
  const Micromaps micromaps{std::span(&arrays.array, primitives.empty() ? 0 : 1), primitives};
  const Bytes written = bytes ? to_glb(file, *bytes, micromaps) : to_glb(file, micromaps);
  for (const FileViolation& violation : validate_micromaps(name, written))
    if (issue_of(violation.rule).severity == Severity::error)
      throw std::logic_error("what would be written breaks a rule: " + describe(violation));
  return written;
}

}  // namespace mmverify::scene
