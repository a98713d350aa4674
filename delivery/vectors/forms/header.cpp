#include <cctype>

#include "delivery/vectors/forms/forms.hpp"
#include "delivery/vectors/forms/part.hpp"

namespace mmverify::vectors {
namespace {

constexpr std::size_t longest_line = 118;

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string c_prefix(const Family& family) { return "mmverify_vectors_" + family.name; }

/// Writes numbers between braces, as many a line as fit.
class Numbers {
 public:
  explicit Numbers(std::string& out) : out_(out) {}
  void add(const std::string& number) {
    if (line_.size() + number.size() + 2 > longest_line) end_line();
    line_ += (line_.empty() ? "  " : " ") + number + ",";
  }
  void end_line() {
    if (!line_.empty()) out_ += line_ + "\n";
    line_.clear();
  }

 private:
  std::string& out_;
  std::string line_;
};

std::string c_members(const Table& table) {
  std::string out;
  for (const Column& column : table.columns) {
    std::string names = column.name;
    if (in_data(column.kind)) names = column.name + "_at, " + column.name + "_size";
    if (column.kind == Kind::optional) names = column.name + ", " + column.name + "_given";
    if (column.kind == Kind::wide || column.kind == Kind::set)
      names = column.name + "_low, " + column.name + "_high";
    std::string about = column.about;
    if (!column.names.empty()) {
      about += column.kind == Kind::set ? "; bits from 0:" : "; from 0:";
      for (const std::string& name : column.names) about += " " + name;
    }
    out += "  uint32_t " + names + "; /* " + name_of(column.kind) + ": " + about + " */\n";
  }
  return out;
}

std::string c_table(const Family& family, const Table& table) {
  const std::string name = c_prefix(family) + "_" + table.name;
  std::string out = "/* " + table.about + " */\ntypedef struct " + name + "_t {\n" + c_members(table) + "} " +
                    name + "_t;\n#define " + upper(name) + " " + std::to_string(table.records()) +
                    "u\nstatic const " + name + "_t " + name + "[" + std::to_string(table.records()) +
                    "] = {\n";
  for (std::size_t record = 0; record < table.records(); ++record) {
    std::string line;
    for_each_value(table, record, [&](const Column& column, std::span<const std::uint32_t> words) {
      for (const std::uint32_t word : words)
        line += (line.empty() ? "" : ", ") +
                (column.kind == Kind::binary32 ? "0x" + hex(word) : std::to_string(word)) + "u";
    });
    out += "  {" + line + "},\n";
  }
  return out + "};\n\n";
}

std::string c_family(const Family& family, const Provenance& made_by) {
  const std::string name = c_prefix(family);
  std::string out = "/* ---- " + family.name + ", version " + std::to_string(family.version) + ": " +
                    family.about + " ---- */\n#define " + upper(name) + "_VERSION " +
                    std::to_string(family.version) + "\n#define " + upper(name) + "_SHA256 \"" +
                    digest(family, made_by) + "\"\n\n";
  out += "/* Why a vector is there, by its member `about`. */\nstatic const char *const " + name + "_about[" +
         std::to_string(family.abouts.size()) + "] = {\n";
  for (const std::string& about : family.abouts) out += "  \"" + about + "\",\n";
  out += "};\n\n";
  for (const Table& table : family.tables) out += c_table(family, table);
  if (family.data.empty()) return out;
  out += "/* What members NAME_at and NAME_size refer to, in bytes. */\nstatic const uint8_t " + name +
         "_data[" + std::to_string(family.data.size()) + "] = {\n";
  Numbers numbers(out);
  for (const std::uint8_t byte : family.data) numbers.add(std::to_string(byte));
  numbers.end_line();
  return out + "};\n\n";
}

}  // namespace

std::string as_header(std::span<const Family> families, const Provenance& made_by) {
  std::string out =
      "/* Test vectors of opacity micromaps, " + std::string(schema_name) + ". Made by mmverify " +
      made_by.version + " (mmverify vectors) from\n * specification " + made_by.spec_hash +
      ".\n * docs/VECTORS.md of mmverify says what each table is and how to use it. A record is made of "
      "32-bit words, as in\n * mmverify_vectors.bin: it can be copied to a GPU as it is. MIT licence.\n"
      " */\n#ifndef MMVERIFY_VECTORS_H\n#define MMVERIFY_VECTORS_H\n\n#include <stdint.h>\n\n"
      "#define MMVERIFY_VECTORS_SCHEMA \"" +
      std::string(schema_name) + "\"\n#define MMVERIFY_VECTORS_MADE_BY \"mmverify " + made_by.version +
      "\"\n#define MMVERIFY_VECTORS_SPEC_HASH \"" + made_by.spec_hash +
      "\"\n\n"
      "/* The number in bytes at .. at+3 of a family's data. */\n"
      "static inline uint32_t mmverify_vectors_word(const uint8_t *data, uint32_t at) {\n"
      "  return (uint32_t)data[at] | (uint32_t)data[at + 1] << 8 | (uint32_t)data[at + 2] << 16 |\n"
      "         (uint32_t)data[at + 3] << 24;\n}\n\n";
  for (const Family& family : families) out += c_family(family, made_by);
  return out + "#endif\n";
}

}  // namespace mmverify::vectors
