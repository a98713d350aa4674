// What a family of vectors is: tables of records, each a row of 32-bit words, and the bytes that they refer to.
//
// The three forms (vectors/forms/) are written from this alone, so that they say the same.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mmverify::vectors {

using Bytes = std::vector<std::uint8_t>;

/// What a column's words mean.
enum class Kind : std::uint8_t {
  number,     ///< one word, a whole number
  binary32,   ///< one word, the bits of an IEEE 754 binary32 number
  name,       ///< one word, the place of a name among the column's names
  about,      ///< one word, the place of a text among the family's: why the vector is there
  optional,   ///< two words, a whole number and 1, or none: 0 and 0
  wide,       ///< two words, a whole number below 2^53, the low one first
  set,        ///< two words, bit k for name k of the column's names
  bytes,      ///< two words, where in the family's data bytes begin, a multiple of 4, and how many there are
  digits,     ///< the same of numbers 0..9, a byte each
  words,      ///< the same of 32-bit numbers; how many bytes
  binary32s,  ///< the same of binary32 numbers
};

/// "number", "optional", ...: as the JSON form names a kind.
const char* name_of(Kind kind);

/// How many words of a record the kind takes.
constexpr std::size_t words_of(Kind kind) { return kind < Kind::optional ? 1 : 2; }

/// Whether the two words name a part of the family's data.
constexpr bool in_data(Kind kind) { return kind >= Kind::bytes; }

struct Column {
  std::string name;
  Kind kind;
  std::string about;
  std::vector<std::string> names = {};  ///< of Kind::name and Kind::set
};

/// Records of one form.
struct Table {
  std::string name;
  std::string about;
  std::vector<Column> columns;
  std::vector<std::uint32_t> words = {};  ///< record after record

  /// Words of a record.
  std::size_t stride() const;
  std::size_t records() const { return words.size() / stride(); }
  std::span<const std::uint32_t> record(std::size_t k) const {
    return std::span(words).subspan(k * stride(), stride());
  }
};

/// Tables of one matter.
struct Family {
  std::string name;
  std::uint32_t version;  ///< grows where a vector of the last version changes or goes
  std::string about;
  std::vector<Table> tables = {};
  Bytes data = {};
  std::vector<std::string> abouts = {};
};

/// The most bytes of a text why a vector is there: a record of the binary form holds it and a 0.
inline constexpr std::size_t longest_about = 63;

}  // namespace mmverify::vectors
