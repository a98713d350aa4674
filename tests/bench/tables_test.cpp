// [release alone] Tables of the benches: what is written has facts, and its description names its unit; the schema made of them.
#include "bench/tree/tables.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "bench/scene/examples.hpp"
#include "bench/schema/schema.hpp"
#include "bench/table.hpp"

namespace {

using namespace mmverify::bench;

std::vector<Result> all_results() {
  std::vector<Result> all = examples_of_topics();
  for (Result& other : other_examples()) all.push_back(std::move(other));
  return all;
}

bool says(const std::string& text, const std::string& unit) {
  return std::regex_search(text, std::regex("(^|[^a-zA-Z])" + unit + "($|[^a-zA-Z])"));
}

using Complaints = std::vector<std::string>;

/// place: what the columns lie in; above: its descriptions.
void judge(const std::string& place, const std::string& above, const std::vector<Column>& columns,
           Complaints& complaints) {
  std::string notes = above;
  for (const Column& column : columns)
    if (column.key.type == Property::Type::object) notes += "; " + column.key.description;
  for (const Column& column : columns) {
    const std::string here = place + "." + column.key.name;
    judge(here, notes + "; " + column.key.description, column.columns, complaints);
    if (!column.key.name.empty() && !column.unit.empty() &&
        !says(notes + "; " + column.key.description, column.unit) && !says(column.key.name, column.unit))
      complaints.push_back(here + ": its description has no '" + column.unit + "'");
  }
}

Complaints complaints_of(const Result& result) {
  Complaints complaints;
  for (const Table& table : result.tables)
    judge(result.topic + "." + table.key.name, table.key.description + "; " + table.row, table.columns,
          complaints);
  return complaints;
}

TEST(BenchTables, EachFiguresDescriptionNamesItsUnit) {
  for (const Result& result : all_results())
    for (const std::string& complaint : complaints_of(result)) ADD_FAILURE() << complaint;
  Result tree = tree_tables({TreeFigures{}}, {});
  for (Column& column : tree.tables.front().columns)
    if (column.key.name == "encode_ns.ours") column.unit = "furlongs";
  EXPECT_EQ(complaints_of(tree), Complaints{"tree.rows.encode_ns.ours: its description has no 'furlongs'"});
}

TEST(BenchTables, EveryTopicHasAPlaceInTheSchema) {
  std::set<std::string> topics, places;
  for (const Result& result : all_results()) topics.insert(result.topic);
  const auto made = schema();
  for (const auto& [name, _] : made.at("$defs").items())
    if (name != "run" && name != "tool") places.insert(name);
  EXPECT_EQ(topics, places);
}

TEST(BenchTables, EveryRowHasAValueForEachColumn) {
  for (const Result& result : all_results())
    for (const Table& table : result.tables)
      for (const Row& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << result.topic;
}

}  // namespace
