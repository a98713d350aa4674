// The forms of the vectors, and the list of the files. docs/VECTORS.md describes them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "delivery/vectors/table.hpp"

namespace mmverify::vectors {

/// The program and the specification that made the vectors.
struct Provenance {
  std::string version;    ///< the program's
  std::string spec_hash;  ///< SHA-256 of the specification, 64 hexadecimal digits
  /// SHA-256 of bytes as 64 hexadecimal digits, given by the caller: this library has none.
  std::string (*sha256)(std::string_view bytes);
};

inline constexpr const char* schema_name = "mmverify.vectors/2";
inline constexpr const char* header_name = "mmverify_vectors.h";
inline constexpr const char* binary_name = "mmverify_vectors.bin";
inline constexpr const char* manifest_name = "MANIFEST.json";

/// The bytes of a family in the order of the binary form: its tables, its data, its texts of 64 bytes each.
std::string payload(const Family& family);

/// SHA-256 of payload(): equal in all forms.
std::string digest(const Family& family, const Provenance& made_by);

/// FAMILY.json: the whole family, a vector a line.
std::string as_json(const Family& family, const Provenance& made_by);

/// mmverify_vectors.h: constant arrays in C99, valid C++ too.
std::string as_header(std::span<const Family> families, const Provenance& made_by);

/// mmverify_vectors.bin: a table of contents, then each table's records, little-endian.
std::string as_binary(std::span<const Family> families, const Provenance& made_by);

/// The answers that a script for Amber expects.
enum class Dialect : std::uint8_t { exact, published };

/// The scripts' names, by Dialect, and the family that they are of.
inline constexpr const char* amber_names[] = {"index_exact.amber", "index_published.amber"};
inline constexpr const char* amber_family = "index";
/// The lines around the function in a script.
inline constexpr const char* amber_mark_begin = "// ---- your function begins ----";
inline constexpr const char* amber_mark_end = "// ---- your function ends ----";

/// A script for Amber (github.com/google/amber): the points of family `index`, an index function in GLSL between two marks,
/// a pipeline that asks it, one that counts its wrong answers, and the expectations.
/// Domain: family `index`.  Test: tests/outside/amber_test.py.
std::string as_amber(const Family& index, Dialect dialect, const Provenance& made_by);

/// A file's name and its bytes.
using File = std::pair<std::string, std::string>;

/// MANIFEST.json: the files with their sizes and hashes, the families with their counts.
std::string manifest(std::span<const Family> families, std::span<const File> files,
                     const Provenance& made_by);

/// The forms to write.
struct Forms {
  bool json = true, header = true, binary = true, amber = false;
};

/// All files of these families in these forms, the manifest last. Amber's scripts are of family `index` alone.
std::vector<File> files_of(std::span<const Family> families, const Provenance& made_by, const Forms& forms);

}  // namespace mmverify::vectors
