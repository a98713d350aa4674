// Reading glTF: from any bytes, a scene that keeps its promises, or one line with the fault.
// Writing it: the scene that was read, with micromaps, reads as the same scene, and keeps the extension's
// rules.
//
// Input: scene_input.hpp.
//
// Covers: scene/scene.* scene/read/* scene/plan/plan.* scene/plan/texel_triangle.* scene/plan/uv_duplicates.*
// Covers: scene/write/*
#include <cmath>

#include "fuzz/scene_input.hpp"
#include "scene/plan/plan.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/load.hpp"
#include "scene/validate/issues.hpp"
#include "scene/validate/micromaps.hpp"
#include "scene/write/glb.hpp"

namespace {

using namespace mmverify::fuzz::scene;
using namespace mmverify::scene;
namespace micromap = mmverify::impl::micromap;

void require(bool holds, const char* what) {
  if (!holds) fail(what);
}

void check_one_line(const BadScene& bad) {
  const std::string what = bad.what();
  require(what.find('\n') == std::string::npos, "an error of two lines");
  require(what.starts_with(std::string(name) + ": "), "an error that does not name its file");
  require(what.size() < 2000, "an error without end");
}

void check(const Primitive& primitive, const Scene& scene) {
  require(primitive.mesh < scene.meshes.size(), "a primitive of no mesh");
  require(!primitive.material || *primitive.material < scene.materials.size(),
          "a material that is not there");
  require(primitive.uvs.empty() || primitive.uvs.size() == primitive.positions.size(),
          "UVs of other vertices");
  for (const Triangle& triangle : primitive.triangles)
    for (const std::uint32_t vertex : triangle)
      require(vertex < primitive.positions.size(), "a vertex that is not there");
  for (const Uv& uv : primitive.uvs) require(std::isfinite(uv[0]) && std::isfinite(uv[1]), "a UV not finite");
  for (const Position& position : primitive.positions)
    for (const float x : position) require(std::isfinite(x), "a position not finite");
}

void check(const Scene& scene) {
  std::uint64_t triangles = 0;
  for (const Primitive& primitive : scene.primitives) {
    check(primitive, scene);
    triangles += primitive.triangles.size();
  }
  require(count_triangles(scene).unique == triangles, "another number of triangles");
  for (const Image& image : scene.images)
    std::visit(
        [&](const auto& alpha) {
          require(alpha.size() == std::size_t{image.width} * image.height, "an image of other texels");
        },
        image.alpha);
}

void check_same(const Scene& a, const Scene& b) {
  require(a.primitives.size() == b.primitives.size() && a.images.size() == b.images.size() &&
              a.materials.size() == b.materials.size() && a.meshes.size() == b.meshes.size(),
          "written, of other numbers");
  for (std::size_t k = 0; k < a.primitives.size(); ++k) {
    const Primitive &p = a.primitives[k], &q = b.primitives[k];
    require(p.triangles == q.triangles, "written, of other triangles");
    require(p.positions == q.positions && p.uvs == q.uvs && p.material == q.material,
            "written, with other vertices");
    require(p.vertex_alpha.has_value() == q.vertex_alpha.has_value() && p.morphs_uvs == q.morphs_uvs,
            "written, with other attributes");
  }
  for (std::size_t k = 0; k < a.images.size(); ++k)
    require(a.images[k].width == b.images[k].width && a.images[k].alpha == b.images[k].alpha,
            "written, with other images");
  for (std::size_t k = 0; k < a.meshes.size(); ++k)
    require(a.meshes[k].uses == b.meshes[k].uses, "written, used differently");
}

void check(const Plan& planned, const Scene& scene) {
  require(planned.primitives.size() + planned.left_out.size() == scene.primitives.size(),
          "a primitive neither planned nor left out");
  for (const LeftOutPrimitive& primitive : planned.left_out)
    require(!sentence(primitive.why).empty(), "left out without a reason");
}

/// The file with codes for the triangles of a plan, in an encoding that the file's length chooses
/// arbitrarily.
Bytes written(const Bytes& file, const Scene& scene, const Plan& planned) {
  const micromap::Array array{{{0, 1, 2}, {1, 0, 1}}, {0xe4, 1}};
  const auto encoding = static_cast<micromap::Encoding>(file.size() % 5);
  const std::size_t width = micromap::width(encoding) / 8;
  std::vector<micromap::Bytes> codes;
  std::vector<PrimitiveMicromaps> primitives;
  codes.reserve(planned.primitives.size());
  for (const PlannedPrimitive& primitive : planned.primitives) {
    micromap::Bytes& its = codes.emplace_back(primitive.triangles.size() * width);
    for (std::size_t t = 0; t < primitive.triangles.size(); ++t) {
      const std::uint32_t code =
          t % 2 == 0 ? t % 4 / 2 : micromap::special_code(micromap::State::UT, encoding);
      for (std::size_t k = 0; k < width; ++k) its[t * width + k] = static_cast<std::uint8_t>(code >> 8 * k);
    }
    const Primitive& given = scene.primitives[primitive.primitive];
    primitives.push_back({given.mesh, given.number, 0, encoding, its, 0});
  }
  const std::span<const micromap::Array> arrays(&array, planned.primitives.empty() ? 0 : 1);
  return to_glb(name, file, {arrays, primitives});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes file = as_file(data, size);
  Scene scene;
  try {
    scene = load(name, file);
  } catch (const BadScene& bad) {
    check_one_line(bad);
    return 0;
  }
  check(scene);
  const Plan planned = plan(scene);
  check(planned, scene);
  Bytes glb;
  try {
    glb = written(file, scene, planned);
  } catch (const BadScene& bad) {  // of unused parts: a view outside its buffer, an unknown picture
    check_one_line(bad);
    return 0;
  }
  for (const FileViolation& violation : validate_micromaps(name, glb))
    if (issue_of(violation.rule).severity == Severity::error) fail("written: " + describe(violation));
  check_same(scene, load(name, glb));
  return 0;
}
