// [release alone] Tables of the benches beside docs/bench.schema.json: what is written has a property there, a rule, and its unit.
#include "bench/array/tables.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "bench/attribute/tables.hpp"
#include "bench/bake/tables.hpp"
#include "bench/baker/tables.hpp"
#include "bench/dag/tables.hpp"
#include "bench/index/tables.hpp"
#include "bench/scene/attribute_mip_tables.hpp"
#include "bench/scene/attribute_tables.hpp"
#include "bench/scene/dag_tables.hpp"
#include "bench/scene/path_tables.hpp"
#include "bench/scene/render_tables.hpp"
#include "bench/scene/tables.hpp"
#include "bench/scene/view_tables.hpp"
#include "bench/shaders/tables.hpp"
#include "bench/subject/tables.hpp"
#include "bench/sweep/tables.hpp"
#include "bench/tree/tables.hpp"
#include "bench/vq/tables.hpp"
#include "delivery/gate/schema.hpp"

namespace {

using namespace mmverify::bench;
namespace gate = mmverify::gate;
using Json = nlohmann::ordered_json;

Result with_pictures(Result result) {
  mmverify::scene::MipStep step;
  step.set = mmverify::scene::set_of(mmverify::scene::Attribute::base_color);
  step.texture = step.faces.error = step.vertices.error = {{1, 0.5}, 2, 1};
  result.tables.push_back(attribute_mips_table({step, step}));
  result.tables.push_back(attribute_mip_pictures_table({{"baseColor", "leaves", 1, "leaves_mip1.png"}}));
  result.tables.push_back(attribute_pictures_table({{"baseColor", "leaves", 1, "leaves_level1.png"}}));
  return result;
}

/// One of each, with figures enough for every table.
std::vector<Result> all_results() {
  IndexFigures index;
  index.name = "step-f32";
  index.uniform = index.hard = {{.level = 1, .samples = 1}};
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
  mmverify::scene::AttributeFigures attributes;
  attributes.texture_bytes = 4;
  attributes.sets.resize(1);
  attributes.sets[0].set = mmverify::scene::set_of(mmverify::scene::Attribute::base_color);
  attributes.sets[0].texels = attributes.sets[0].texture_bytes = 4;
  attributes.sets[0].levels.resize(2);
  attributes.sets[0].levels[1].kind = mmverify::scene::MapKind::vertices;
  attributes.sets[0].levels[1].nearest.emplace();
  for (auto& level : attributes.sets[0].levels)
    level.packed = {.plain = 3, .packed = 2, .entropy = 1, .peer = 4, .worst_error = 2, .rms_error = 1.5};
  for (const mmverify::scene::BlockSize block : {mmverify::scene::BlockSize{4, 4}, {12, 12}})
    attributes.sets[0].compressed.push_back(
        {block, 1, 16u * 144 / (block.width * block.height), 16, {1, 0.5}});
  attributes.sets[0].levels[0].error = {1, 0.5};
  mmverify::scene::AttributeScene read;
  read.left_out.push_back({.why = "no texture"});
  RenderFigures rendered;
  rendered.methods.resize(1);
  rendered.methods[0].level = 2;
  rendered.methods[0].predicted = rendered.methods[0].even = 0.5;
  rendered.blends.resize(1);
  rendered.blends[0].level = 2;
  rendered.operation = "max";
  rendered.colours = "faces";
  rendered.pictures = {{"heat", "heat.png"}};
  mmverify::render::Path along;
  along.cameras.resize(1);
  along.rows.resize(1);
  along.rows[0].level = 2;
  PathFigures walked;
  walked.path = &along;
  mmverify::bench::ViewFigures seen;
  seen.rows.resize(1);
  seen.rows[0].file = "faces_level0.png";
  SceneDagScene dag;
  dag.rows.resize(1);
  dag.rows[0].bits = 1;
  dag.rows[0].context_bytes = 1;
  for (SceneFormFigures& form : dag.rows[0].forms) form = {1, 1, 1, 1};
  dag.squares.resize(1);
  dag.growth.resize(1);
  return {index_tables({index}, {}),
          tree_tables({TreeFigures{}}, {}),
          dag_tables({DagFigures{}}, {}),
          vq_tables(vq, {}),
          bake_tables(bake, {}),
          attribute_tables(maps, {}),
          array_tables({ArrayFigures{}}, {}),
          sweep_tables({}),
          subject_tables({}),
          shader_tables({.about = {{"device", "a test's"}}, .rows = {{"index", 4, 1, 1, 0}}}),
          scene_bake_tables({}, {}),
          scene_dag_tables(dag, {}),
          baker_tables({"b", "f", {{}}}),
          render_tables(rendered),
          path_tables(walked),
          view_tables(seen),
          with_pictures(scene_attribute_tables(
              attributes, read,
              {.packed = true, .texture_coder = {.name = "coder", .compress = [](auto&&...) {}}}))};
}

/// What the schema says of one place, and of the places that it lies in.
struct Place {
  std::string name;
  std::vector<gate::Schema> schemas;
  bool left_out = false;  ///< here, or with what it lies in
  bool has_rule = false;
  std::string descriptions = {};

  Place step(const std::string& to, const std::vector<gate::Schema>& found) const {
    Place next{name + to, {}, left_out, left_out, descriptions};
    for (const gate::Schema& one : found)
      for (const gate::Schema& also : gate::all_of(one, nullptr))
        if (also.part->is_object()) next.schemas.push_back(also);
    for (const gate::Schema& s : next.schemas) {
      next.has_rule = next.has_rule || s.part->contains("x-gate");
      next.left_out = next.left_out || s.part->value("x-gate", "") == "left_out";
      next.descriptions += "; " + s.part->value("description", "");
    }
    return next;
  }
  Place member(const std::string& key) const {
    const auto dot = key.find('.');
    const std::string first = key.substr(0, dot);
    const Place next = step("." + first, gate::of_member(schemas, first));
    return dot == std::string::npos ? next : next.member(key.substr(dot + 1));
  }
  Place elements() const { return step("[]", gate::of_elements(schemas)); }
};

bool says(const std::string& text, const std::string& unit) {
  return std::regex_search(text, std::regex("(^|[^a-zA-Z])" + unit + "($|[^a-zA-Z])"));
}

using Complaints = std::vector<std::string>;

void judge_rows(const Place& place, Form form, const std::vector<Column>& columns,
                const std::vector<Row>& rows, Complaints& complaints);

void judge(const Place& place, const Column& column, const Value* value, Complaints& complaints) {
  if (place.schemas.empty()) {
    complaints.push_back(place.name + ": the schema has no such property");
  } else if (!column.columns.empty()) {
    const auto* rows = value == nullptr ? nullptr : std::get_if<std::vector<Row>>(value);
    judge_rows(place, column.form, column.columns, rows == nullptr ? std::vector<Row>{} : *rows, complaints);
  } else {
    const bool list = value != nullptr && std::holds_alternative<std::vector<std::uint64_t>>(*value);
    if (!place.has_rule && !(list && place.elements().has_rule))
      complaints.push_back(place.name + ": the schema has no x-gate for it");
    if (!column.unit.empty() && !says(place.descriptions, column.unit) && !says(column.key, column.unit))
      complaints.push_back(place.name + ": its description has no '" + column.unit + "'");
  }
}

void judge_columns(const Place& place, std::size_t first, const std::vector<Column>& columns, const Row* row,
                   Complaints& complaints) {
  for (std::size_t k = first; k < columns.size(); ++k)
    if (!columns[k].key.empty())
      judge(place.member(columns[k].key), columns[k], row == nullptr ? nullptr : &(*row)[k], complaints);
}

void judge_rows(const Place& place, Form form, const std::vector<Column>& columns,
                const std::vector<Row>& rows, Complaints& complaints) {
  if (form == Form::members) judge_columns(place, 0, columns, &rows.front(), complaints);
  if (form == Form::list)
    judge_columns(place.elements(), 0, columns, rows.empty() ? nullptr : &rows.front(), complaints);
  if (form == Form::object) {
    if (rows.empty()) complaints.push_back(place.name + ": nothing names its members");
    for (const Row& row : rows)
      judge_columns(place.member(std::get<std::string>(row.front())), 1, columns, &row, complaints);
  }
}

Complaints complaints_of(const Result& result) {
  const gate::Schema schema = *gate::schema_named("mmverify.bench/1");
  const Json header{{"topic", result.topic}};
  const Place root{result.topic, gate::all_of(schema, &header)};
  Complaints complaints;
  for (const auto& [name, value] : result.settings)
    judge(root.member("tool." + name), {.key = name}, &value, complaints);
  for (const Table& table : result.tables)
    judge_rows(table.key.empty() ? root : root.member(table.key), table.form, table.columns, table.rows,
               complaints);
  return complaints;
}

TEST(BenchTables, EachFigureHasAPropertyARuleAndItsUnitInTheSchema) {
  for (const Result& result : all_results())
    for (const std::string& complaint : complaints_of(result)) ADD_FAILURE() << complaint;
}

TEST(BenchTables, AreThoseOfEveryTopicOfTheSchema) {
  std::set<std::string> topics;
  for (const Result& result : all_results()) topics.insert(result.topic);
  const Json named =
      gate::schema_named("mmverify.bench/1")->document->at("/$defs/run/properties/topic/enum"_json_pointer);
  EXPECT_EQ(topics, named.get<std::set<std::string>>());
}

TEST(BenchTables, AColumnThatTheSchemaDoesNotKnowIsNamed) {
  Result tree = tree_tables({TreeFigures{}}, {});
  Table& rows = tree.tables.front();
  rows.columns[1].key = "depth";
  for (Column& column : rows.columns)
    if (column.key == "encode_ns.ours") column.unit = "furlongs";
  tree.settings.front().first = "luck";
  const Complaints expected{"tree.tool.luck: the schema has no such property",
                            "tree.rows[].depth: the schema has no such property",
                            "tree.rows[].encode_ns.ours: its description has no 'furlongs'"};
  EXPECT_EQ(complaints_of(tree), expected);
}

TEST(BenchTables, AFieldWithoutARuleIsNamed) {
  // "tool" has members with rules, and none of its own.
  Result subject = subject_tables({});
  subject.tables.front().columns[0].key = "tool";
  EXPECT_EQ(complaints_of(subject), Complaints{"subject.tool: the schema has no x-gate for it"});
}

TEST(BenchTables, EveryRowHasAValueForEachColumn) {
  for (const Result& result : all_results())
    for (const Table& table : result.tables)
      for (const Row& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << result.topic;
}

}  // namespace
