// Tables of figures, the results of benches.  Each figure is described once for all printers and writers.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bench/property.hpp"

namespace mmverify::bench {

struct Value;
using Row = std::vector<Value>;

/// The value of a cell: nothing, a whole number, a real one, a text, whole numbers, or the rows of a table
/// within.
struct Value : std::variant<std::monostate, std::uint64_t, double, std::string, std::vector<std::uint64_t>,
                            std::vector<Row>> {
  using variant::variant;
};

/// The format of a printed real number: value * factor.  Whole numbers are printed with commas.
struct Print {
  int digits = 2;
  char type =
      'f';  ///< printf's f, e or g: `digits` after the point, with a power of ten for e; significant for g
  double factor = 1;
  const char* unit = "";   ///< the printed unit, if the factor changes the unit
  const char* none = "-";  ///< printed if there is no value
};
inline constexpr double per_cent = 100, millions = 1e-6;
inline constexpr Print plain = {};
constexpr Print digits(int after_the_point) { return {.digits = after_the_point}; }
constexpr Print percents(int after_the_point) { return {after_the_point, 'f', per_cent, "%"}; }

/// The form of a table's rows in JSON.
enum class Form : std::uint8_t {
  list,     ///< a list of objects
  object,   ///< an object: the first column names its members
  members,  ///< of the one row, members of the whole; printed as lines of heading and value
  printed,  ///< nothing: the table is printed alone
};

/// The printed form of the rows of a table within.
enum class RowLayout : std::uint8_t {
  below,   ///< a line each
  beside,  ///< side by side: each figure under the names of the rows
};

struct Column {
  Property key = {};         ///< in JSON
  std::string heading = {};  ///< empty: written only
  std::string unit = {};     ///< of the value as written
  Print print = {};
  std::string group = {};            ///< columns of one group are printed together, below its name
  bool leads = false;                ///< names the subject of a row: begins each line of the table
  std::vector<Column> columns = {};  ///< of a table within; its rows are the value
  RowLayout within = RowLayout::below;
  Form form = Form::list;  ///< of a table within
  std::string row = {};    ///< a description of its rows
};

struct Table {
  Property key = {};         ///< in JSON; without facts a list of one row at least
  std::string row = {};      ///< a description of the rows
  std::string caption = {};  ///< printed above
  Form form = Form::list;
  std::vector<Column> columns = {};
  std::vector<Row> rows = {};
  bool beside = false;  ///< rows that differ only in the last leading column are printed side by side
};

/// A column, and the function that takes its value from a figure of type T.
template <class T>
struct Field {
  Column column;
  std::function<Value(const T&)> of;
};
template <class T>
using Fields = std::vector<Field<T>>;

/// A column without values: what the schema says of an object that other columns are members of.
template <class T>
Field<T> note(Property object) {
  return {{.key = std::move(object)}, [](const T&) { return Value(); }};
}

template <class T>
std::vector<Column> columns_of(const Fields<T>& fields) {
  std::vector<Column> columns;
  for (const Field<T>& field : fields) columns.push_back(field.column);
  return columns;
}

template <class T>
std::vector<Row> rows_of(const Fields<T>& fields, const std::vector<T>& figures) {
  std::vector<Row> rows;
  for (const T& figure : figures) {
    rows.emplace_back();
    for (const Field<T>& field : fields) rows.back().push_back(field.of(figure));
  }
  return rows;
}

/// A table like `frame`, with a row for each figure.
template <class T>
Table table_of(Table frame, const Fields<T>& fields, const std::vector<T>& figures) {
  frame.columns = columns_of(fields);
  frame.rows = rows_of(fields, figures);
  return frame;
}

/// A column like `column` with a table within, of the figures that a T has.
template <class T, class U>
Field<T> within(Column column, const Fields<U>& fields, std::function<std::vector<U>(const T&)> figures) {
  column.columns = columns_of(fields);
  return {std::move(column), [fields, figures = std::move(figures)](const T& of) -> Value {
            return rows_of(fields, figures(of));
          }};
}

}  // namespace mmverify::bench
