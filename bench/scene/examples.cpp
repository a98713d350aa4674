#include "bench/scene/examples.hpp"

#include "bench/array/tables.hpp"
#include "bench/attribute/tables.hpp"
#include "bench/bake/tables.hpp"
#include "bench/baker/tables.hpp"
#include "bench/codec/tables.hpp"
#include "bench/dag/tables.hpp"
#include "bench/index/tables.hpp"
#include "bench/scene/astcenc.hpp"
#include "bench/scene/attribute_mip_tables.hpp"
#include "bench/scene/attribute_plan_tables.hpp"
#include "bench/scene/attribute_tables.hpp"
#include "bench/scene/attribute_times.hpp"
#include "bench/scene/bc7enc.hpp"
#include "bench/scene/dag_tables.hpp"
#include "bench/scene/path_tables.hpp"
#include "bench/scene/render_tables.hpp"
#include "bench/scene/tables.hpp"
#include "bench/scene/view_tables.hpp"
#include "bench/shaders/tables.hpp"
#include "bench/stiff/tables.hpp"
#include "bench/subdivision/tables.hpp"
#include "bench/subject/tables.hpp"
#include "bench/sweep/tables.hpp"
#include "bench/tree/tables.hpp"
#include "bench/vq/tables.hpp"

namespace mmverify::bench {
namespace {

scene::AttributeFigures attribute_figures_of(const scene::TextureCoder& coder) {
  scene::AttributeFigures attributes;
  attributes.texture_bytes = 4;
  attributes.sets.resize(1);
  scene::AttributeSetFigures& set = attributes.sets[0];
  set.set = scene::set_of(scene::Attribute::base_color);
  set.texels = set.texture_bytes = 4;
  set.levels.resize(2);
  set.levels[1].kind = scene::MapKind::vertices;
  set.levels[1].nearest.emplace();
  for (auto& level : set.levels)
    level.packed = {.plain = 3, .packed = 2, .entropy = 1, .peer = 4, .worst_error = 2, .rms_error = 1.5};
  for (const scene::BlockSize block : coder.blocks)
    set.compressed.push_back({block, 1, 16u * 144 / (block.width * block.height), 16, {1, 0.5}});
  set.levels[0].error = {1, 0.5};
  return attributes;
}

/// The tables of a scene's attributes, its textures compressed by this coder.
Result attributes_by(scene::TextureCoder coder) {
  coder.name = "coder";
  coder.compress = [](auto&&...) {};
  const scene::AttributeFigures figures = attribute_figures_of(coder);
  scene::AttributeScene read;
  read.left_out.push_back({.why = "no texture"});
  Result result = scene_attribute_tables(figures, read, {.packed = true, .texture_coder = coder});
  scene::MipStep step;
  step.set = figures.sets[0].set;
  step.texture = step.faces.error = step.vertices.error = {{1, 0.5}, 2, 1};
  result.tables.push_back(attribute_mips_table({step, step}));
  result.tables.push_back(attribute_mip_pictures_table({{"baseColor", "leaves", 1, "leaves_mip1.png"}}));
  result.tables.push_back(attribute_pictures_table({{"baseColor", "leaves", 1, "leaves_level1.png"}}));
  result.tables.push_back(attribute_times_table({}));
  for (Table& table : attribute_plan_tables(figures, {})) result.tables.push_back(std::move(table));
  return result;
}

Result rendered() {
  RenderFigures figures;
  figures.states = 2;
  figures.ambient = 1;
  figures.methods.resize(1);
  figures.methods[0].level = 2;
  figures.methods[0].flip = 0.5;
  figures.methods[0].apart = 0;
  figures.methods[0].counts.ambient_rays = 1;
  figures.methods[0].predicted = figures.methods[0].even = 0.5;
  figures.blends.resize(1);
  figures.blends[0].level = 2;
  figures.operation = "max";
  figures.colours = "faces";
  figures.pictures = {{"heat", "heat.png"}};
  return render_tables(figures);
}

Result walked() {
  render::Path along;
  along.cameras.resize(1);
  along.rows.resize(1);
  along.rows[0].level = 2;
  along.cameras[0].frame.counts.ambient_rays = 1;
  PathFigures figures;
  figures.ambient = 1;
  figures.path = &along;
  return path_tables(figures);
}

Result seen() {
  ViewFigures figures;
  figures.rows.resize(1);
  figures.rows[0].file = "faces_level0.png";
  figures.reference = 2;
  return view_tables(figures);
}

Result scene_dag() {
  SceneDagScene dag;
  dag.rows.resize(1);
  dag.rows[0].bits = 1;
  dag.rows[0].context_bytes = 1;
  for (SceneFormFigures& form : dag.rows[0].forms) form = {1, 1, 1, 1};
  dag.squares.resize(1);
  dag.growth.resize(1);
  return scene_dag_tables(dag, {});
}

}  // namespace

std::vector<Result> examples_of_topics() {
  IndexFigures index;
  index.name = "step-f32";
  index.uniform = index.stiff = {{.level = 1, .samples = 1}};
  index.times = {{.level = 1}};
  BakeFigures bake;
  bake.levels.resize(1);
  AttributeFigures maps;
  maps.lookups.resize(1);
  maps.lookups[0].bilinear_ns = maps.lookups[0].bilinear_simd_ns = 1;
  maps.lookups[0].orders = {{.order = "Bird", .lookup_ns = 1, .lookup_to_bilinear = 1}};
  maps.remaps.resize(1);
  maps.bakes.resize(1);
  maps.mips = {{.level = 1, .ways = {{.way = "mip, half up"}}}};
  maps.lods.resize(1);
  VqFigures vq;
  vq.rows.resize(1);
  return {index_tables({index}, {}),
          tree_tables({TreeFigures{}}, {}),
          dag_tables({DagFigures{}}, {}),
          vq_tables(vq, {}),
          bake_tables(bake, {}),
          attribute_tables(maps, {}),
          array_tables({ArrayFigures{}}, {}),
          subdivision_tables({{"hilbert", 2, 1, 1, 1, 1}}, {{"terrain", 8, 1, 1, 1, 1}}, {}),
          stiff_tables({{.kind = "lines", .method = "ours", .cases = 1, .ratio = 1}}, {})};
}

/// A row with every figure.
CodecRow codec_row() {
  CodecRow row{.of = {.of = "leaves", .level = 3}, .encode_ratio = 1, .decode_ratio = 1, .look_up_ratio = 1};
  for (CodecFigures* f : {&row.theirs, &row.ours}) *f = {1, 0, 0, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  return row;
}

Result on_device() {
  ShaderFigures figures;
  figures.bandwidth = 1;
  figures.about = {{"device", "a test's"}};
  figures.rows = {{"index", 4, 1, "coherent", 2, 1, 1, 0, 1, 1}};
  return shader_tables(figures);
}

std::vector<Result> other_examples() {
  const scene::TextureCoder astc{.blocks = {std::begin(astc_blocks), std::end(astc_blocks)}};
  const scene::TextureCoder bc7{.blocks = {bc7_block}, .key = "bc7", .format = "BC7"};
  return {sweep_tables({}),
          subject_tables({}),
          codec_tables({codec_row()}, {"m.so", "impl", 5}),
          scene_bake_tables({}, {}),
          scene_dag(),
          baker_tables({"b", "f", {{}}}),
          attributes_by(astc),
          attributes_by(bc7),
          rendered(),
          walked(),
          on_device(),
          seen()};
}

}  // namespace mmverify::bench
