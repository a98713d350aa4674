#include "cli/scene/wrong_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/arguments/arguments.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/png_file.hpp"
#include "cli/output/streams.hpp"
#include "cli/validate/validate.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/shape.hpp"
#include "scene/picture/opacity_picture.hpp"
#include "scene/read/bad_scene.hpp"
#include "scene/read/load.hpp"
#include "scene/read/primitives.hpp"

namespace mmverify::cli {
namespace {

using namespace mmverify::scene;
using proofs::scene::Cause;
using proofs::scene::Judged;

/// Texels of the images that no material names, which the search for a cause may decode.
constexpr std::uint64_t most_other_texels = std::uint64_t{1} << 26;

/// The cause of wrong maps, if one change explains all of them.
std::optional<Cause> cause_of(const CheckMapsOptions& options, bool two_state, const Scene& scene,
                              const StoredMaps& all) {
  const StoredMaps maps = without_varying_alpha(all);
  if (maps.plan.triangles.empty()) return {};
  const Document document = open_document(options.file);
  const Buffers buffers(document);
  Scene with_images = scene;
  decode_other_images(document, with_images, most_other_texels);
  Judged judged{with_images, maps, options.margin, two_state};
  judged.until = std::chrono::steady_clock::now() + proofs::scene::most_cause_time;
  judged.uvs = [&](const Primitive& primitive, const BaseColorTexture& texture) {
    try {
      return read_uvs(document, buffers, primitive, texture);
    } catch (const BadScene&) {
      return std::vector<Uv>();  // that set, or these UVs, cannot be read: no baker took them
    }
  };
  return proofs::scene::cause_of(judged);
}

std::string json_of(const std::optional<Cause>& cause) {
  if (!cause) return "null";
  return nlohmann::json{
      {"code", cause->code}, {"says", cause->says}, {"wrong", cause->wrong}, {"explained", cause->explained}}
      .dump();
}

/// Whether repair undoes a cause without baking.
bool is_repairable(const std::string& code) {
  constexpr std::array codes{"states",
                             "unknown_side",
                             "order",
                             "corners",
                             "corners+other_triangles",
                             "base_triangle",
                             "other_micromap",
                             "micromaps_exchanged",
                             "other_primitive",
                             "primitives_exchanged",
                             "triangles_reversed",
                             "other_triangles",
                             "special_index"};
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

void print_cause(std::FILE* out, const std::optional<Cause>& cause) {
  if (!cause)
    say(out, "cause: no single change explains these maps\n");
  else
    say(out, "cause: {}: {}; it explains {} of {} wrong triangles\n", cause->code, cause->says,
        grouped(cause->explained), grouped(cause->wrong));
}

/// A note if most unknown states are on the other side, which breaks no law.
std::string print_side(std::FILE* out, const CheckMapsOptions& options, bool two_state, const Scene& scene,
                       const StoredMaps& all) {
  const StoredMaps maps = without_varying_alpha(all);
  if (two_state || maps.plan.triangles.empty()) return {};
  const std::optional<Cause> cause =
      proofs::scene::side_cause_of(Judged{scene, maps, options.margin, false, {}});
  if (!cause) return {};
  say(out, "note: {}: {}\n", cause->code, cause->says);
  print_repair(out, options, cause);
  return json_of(cause);
}

/// The place of the first counterexample: the planned triangle and its micro-triangle.
std::optional<std::pair<std::size_t, std::uint32_t>> first_wrong(const proofs::Report& report) {
  for (const proofs::Result& result : report.results)
    for (const proofs::Counterexample& c : result.counterexamples)
      if (const proofs::Groups parts = proofs::groups_of(c.at, "t([0-9]{1,15}):i([0-9]{1,9})"))
        return std::pair(std::stoull((*parts)[1]), static_cast<std::uint32_t>(std::stoul((*parts)[2])));
  return {};
}

/// Draws the first wrong micro-triangle's map on its texture.
void draw_wrong(std::FILE* out, OutputFile& file, const std::string& path, const Scene& scene,
                const StoredMaps& maps, const proofs::Report& report) {
  constexpr std::uint32_t longest = 1024;
  const auto wrong = first_wrong(report);
  if (!wrong || wrong->first >= maps.plan.triangles.size()) return;
  const auto [triangle, index] = *wrong;
  const PlannedTriangle& planned = maps.plan.triangles[triangle];
  const Surface& surface = maps.plan.surfaces[planned.surface];
  const RgbPicture picture = opacity_picture(scene.images[surface.image], surface,
                                             {{planned.uvs, maps.baked.triangles[triangle]}}, longest, index);
  commit_png(file, picture.width, picture.height, picture.rgb);
  const MapLink& link = maps.link(triangle);
  const Primitive& primitive = scene.primitives[link.primitive];
  say(out, "picture: {}: mesh {} primitive {} triangle {}, micro-triangle {} in red\n", path, primitive.mesh,
      primitive.number, link.triangle, index);
}

}  // namespace

void print_repair(std::FILE* out, const CheckMapsOptions& options, const std::optional<Cause>& cause) {
  if (!options.raw.data.empty()) return;
  const bool is_enough = cause && is_repairable(cause->code) && cause->explained == cause->wrong;
  say(out, "next: mmverify repair {} -o OUT{}{}\n", shell_quoted(options.file),
      options.file.ends_with(".gltf") ? ".gltf" : ".glb", is_enough ? "" : " --bake");
}

std::string print_why(std::FILE* out, const CheckMapsOptions& options, bool two_state, const Scene& scene,
                      const StoredMaps& maps, const proofs::Report& report, OutputFile* picture,
                      bool rules_first) {
  std::optional<Cause> cause;
  try {
    if (exit_code(report) != failed) {
      if (picture != nullptr) say(out, "picture: not drawn: no micro-triangle is wrong\n");
      return print_side(out, options, two_state, scene, maps);
    }
    if (picture != nullptr) draw_wrong(out, *picture, options.picture, scene, maps, report);
    if (rules_first) {
      say(out, "cause: the file breaks rules, named above; its maps may be right when these are kept\n");
      print_repair(out, options.file);
      return json_of({});
    }
    if (!options.quiet)
      say(stderr, "progress: looking for a cause, for at most {} s\n",
          proofs::scene::most_cause_time.count());
    cause = cause_of(options, two_state, scene, maps);
  } catch (const proofs::scene::OutOfTime&) {
    say(out, "cause: none was found within {} s\n", proofs::scene::most_cause_time.count());
    print_repair(out, options, {});
    return json_of({});
  } catch (const proofs::Interrupted&) {
    say(out, "cause: the search was interrupted\n");
    return json_of({});
  }
  const auto wrong = first_wrong(report);
  if (!cause && wrong && wrong->first < maps.plan.triangles.size() &&
      maps.plan.triangles[wrong->first].varies()) {
    say(out, "cause: not looked for where vertex alpha varies\n");
    if (options.raw.data.empty())
      say(out, "next: mmverify scene {} -o OUT.glb\n", shell_quoted(options.file));
    return json_of(cause);
  }
  print_cause(out, cause);
  print_repair(out, options, cause);
  return json_of(cause);
}

}  // namespace mmverify::cli
