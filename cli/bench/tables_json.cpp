#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/bench/tables.hpp"
#include "cli/output/json_text.hpp"
#include "cli/tool.hpp"

namespace mmverify::cli {
namespace {

using bench::Column;
using bench::Form;
using bench::Row;
using bench::Value;
using Json = nlohmann::ordered_json;

Json rows_json(Form form, const std::vector<Column>& columns, const std::vector<Row>& rows);

struct CellJson {
  const Column& column;

  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(const std::vector<Row>& rows) const { return rows_json(column.form, column.columns, rows); }
  template <class Plain>
  Json operator()(const Plain& value) const {
    return value;
  }
};

/// The member that a key names: "a.b" is member b of the object a.
Json& member(Json& object, const std::string& key) {
  const auto dot = key.find('.');
  if (dot == std::string::npos) return object[key];
  return member(object[key.substr(0, dot)], key.substr(dot + 1));
}

/// A row as an object. first: the column to begin with.
Json row_json(const std::vector<Column>& columns, const Row& row, std::size_t first = 0) {
  Json object = Json::object();
  for (std::size_t k = first; k < columns.size(); ++k)
    if (!columns[k].key.name.empty() && row[k].index() != 0)
      member(object, columns[k].key.name) = std::visit(CellJson{columns[k]}, row[k]);
  return object;
}

Json rows_json(Form form, const std::vector<Column>& columns, const std::vector<Row>& rows) {
  Json all = form == Form::object ? Json::object() : Json::array();
  for (const Row& row : rows)
    if (form == Form::object)
      all[std::get<std::string>(row.front())] = row_json(columns, row, 1);
    else
      all.push_back(row_json(columns, row));
  return all;
}

}  // namespace

std::string result_json(const bench::Result& result) {
  Json settings = Json::object();
  for (const auto& [key, value] : result.settings) settings[key.name] = std::visit(CellJson{{}}, value);
  Json all{{"schema", "mmverify.bench/1"}, {"topic", result.topic}, {"tool", tool(settings)}};
  for (const bench::Table& table : result.tables) {
    if (table.form == Form::members)
      all.update(row_json(table.columns, table.rows.front()));
    else if (table.form != Form::printed)
      all[table.key.name] = rows_json(table.form, table.columns, table.rows);
  }
  return json_text(all);
}

}  // namespace mmverify::cli
