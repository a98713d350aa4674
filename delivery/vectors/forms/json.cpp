#include <stdexcept>

#include "delivery/vectors/forms/forms.hpp"
#include "delivery/vectors/forms/part.hpp"

namespace mmverify::vectors {
namespace {

/// The text in JSON quotes. Texts are the library's own: printable ASCII.
std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c < 0x20 || c > 0x7e) throw std::logic_error("vectors: a text that is not printable ASCII");
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out += '"';
}

/// A JSON list.
template <class Items, class Write>
std::string list(const Items& items, Write write) {
  std::string out = "[";
  for (const auto& item : items) out += (out.size() == 1 ? "" : ",") + write(item);
  return out + "]";
}

std::vector<std::uint32_t> words_in(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint32_t> words;
  for (std::size_t at = 0; at < bytes.size(); at += 4)
    words.push_back(bytes[at] | std::uint32_t{bytes[at + 1]} << 8 | std::uint32_t{bytes[at + 2]} << 16 |
                    std::uint32_t{bytes[at + 3]} << 24);
  return words;
}

std::string value(const Family& family, const Column& column, std::span<const std::uint32_t> words) {
  const auto number = [](std::uint32_t word) { return std::to_string(word); };
  const auto hex_text = [](std::uint32_t word) { return quoted(hex(word)); };
  switch (column.kind) {
    case Kind::number: return number(words[0]);
    case Kind::optional: return words[1] == 0 ? "null" : number(words[0]);
    case Kind::binary32: return hex_text(words[0]);
    case Kind::name: return quoted(column.names.at(words[0]));
    case Kind::about: return quoted(family.abouts.at(words[0]));
    case Kind::wide: return std::to_string(wide_at(words));
    case Kind::set: {
      std::vector<std::string> names;
      for (std::size_t k = 0; k < column.names.size(); ++k)
        if ((wide_at(words) >> k & 1) != 0) names.push_back(column.names[k]);
      return list(names, quoted);
    }
    case Kind::bytes: {
      std::string text;
      for (const std::uint8_t byte : part_at(family, words)) text += hex(byte).substr(6);
      return quoted(text);
    }
    case Kind::digits: {
      std::string text;
      for (const std::uint8_t digit : part_at(family, words)) text += static_cast<char>('0' + digit);
      return quoted(text);
    }
    case Kind::words: return list(words_in(part_at(family, words)), number);
    case Kind::binary32s: break;
  }
  return list(words_in(part_at(family, words)), hex_text);
}

std::string column_text(const Column& column) {
  std::string out = "{\"name\": " + quoted(column.name) + ", \"kind\": " + quoted(name_of(column.kind)) +
                    ", \"about\": " + quoted(column.about);
  if (!column.names.empty()) out += ", \"names\": " + list(column.names, quoted);
  return out + "}";
}

std::string table_text(const Family& family, const Table& table) {
  std::string out = "  {\"table\": " + quoted(table.name) + ",\n   \"about\": " + quoted(table.about) +
                    ",\n   \"columns\": [\n";
  for (std::size_t k = 0; k < table.columns.size(); ++k)
    out += "    " + column_text(table.columns[k]) + (k + 1 == table.columns.size() ? "\n" : ",\n");
  out += "   ],\n   \"vectors\": [\n";
  for (std::size_t record = 0; record < table.records(); ++record) {
    out += "    {\"id\":" + std::to_string(record);
    for_each_value(table, record, [&](const Column& column, std::span<const std::uint32_t> words) {
      out += "," + quoted(column.name) + ":" + value(family, column, words);
    });
    out += record + 1 == table.records() ? "}\n" : "},\n";
  }
  return out + "   ]}";
}

std::string tool(const Provenance& made_by) {
  return "{\"name\": \"mmverify\", \"version\": " + quoted(made_by.version) +
         ", \"spec_hash\": " + quoted(made_by.spec_hash) + "}";
}

}  // namespace

std::string as_json(const Family& family, const Provenance& made_by) {
  std::string out = "{\n \"schema\": " + quoted(schema_name) + ",\n \"family\": " + quoted(family.name) +
                    ",\n \"version\": " + std::to_string(family.version) +
                    ",\n \"about\": " + quoted(family.about) + ",\n \"tool\": " + tool(made_by) +
                    ",\n \"sha256\": " + quoted(digest(family, made_by)) + ",\n \"tables\": [\n";
  for (std::size_t k = 0; k < family.tables.size(); ++k)
    out += table_text(family, family.tables[k]) + (k + 1 == family.tables.size() ? "\n" : ",\n");
  return out + " ]\n}\n";
}

std::string manifest(std::span<const Family> families, std::span<const File> files,
                     const Provenance& made_by) {
  std::string out =
      "{\n \"schema\": " + quoted(schema_name) + ",\n \"tool\": " + tool(made_by) + ",\n \"families\": [\n";
  for (std::size_t k = 0; k < families.size(); ++k) {
    const Family& family = families[k];
    out += "  {\"family\": " + quoted(family.name) + ", \"version\": " + std::to_string(family.version) +
           ", \"sha256\": " + quoted(digest(family, made_by)) + ", \"tables\": " +
           list(family.tables,
                [](const Table& table) {
                  return "{\"table\": " + quoted(table.name) +
                         ", \"vectors\": " + std::to_string(table.records()) + "}";
                }) +
           (k + 1 == families.size() ? "}\n" : "},\n");
  }
  out += " ],\n \"files\": [\n";
  for (std::size_t k = 0; k < files.size(); ++k)
    out +=
        "  {\"file\": " + quoted(files[k].first) + ", \"bytes\": " + std::to_string(files[k].second.size()) +
        ", \"sha256\": " + quoted(made_by.sha256(files[k].second)) + (k + 1 == files.size() ? "}\n" : "},\n");
  return out + " ]\n}\n";
}

std::vector<File> files_of(std::span<const Family> families, const Provenance& made_by, const Forms& forms) {
  std::vector<File> files;
  for (const Family& family : families) {
    if (forms.json) files.emplace_back(family.name + ".json", as_json(family, made_by));
    if (!forms.amber || family.name != amber_family) continue;
    for (const Dialect dialect : {Dialect::exact, Dialect::published})
      files.emplace_back(amber_names[static_cast<std::size_t>(dialect)], as_amber(family, dialect, made_by));
  }
  if (forms.header) files.emplace_back(header_name, as_header(families, made_by));
  if (forms.binary) files.emplace_back(binary_name, as_binary(families, made_by));
  files.emplace_back(manifest_name, manifest(families, files, made_by));
  return files;
}

}  // namespace mmverify::vectors
