// A family of vectors: tables of records, each a row of 32-bit words, and the bytes that they refer to.
//
// The forms (delivery/vectors/forms/) are written from this alone, so that they agree.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace mmverify::vectors {

using Bytes = std::vector<std::uint8_t>;

/// The meaning of a column's words.
enum class Kind : std::uint8_t {
  number,     ///< one word, a whole number
  binary32,   ///< one word, the bits of an IEEE 754 binary32 number
  name,       ///< one word, the place of a name among the column's names
  about,      ///< one word, the place of a text among the family's: the reason for the vector
  optional,   ///< two words, a whole number and 1; or 0 and 0 for none
  wide,       ///< two words, a whole number below 2^53, the low one first
  set,        ///< two words, bit k for name k of the column's names
  bytes,      ///< two words: the bytes' offset in the family's data, a multiple of 4, and their number
  digits,     ///< the same for numbers 0..9, a byte each
  words,      ///< the same for 32-bit numbers; the second word counts bytes
  binary32s,  ///< the same for binary32 numbers; the second word counts bytes
};

/// The kind's name in the JSON form: "number", "optional", ...
const char* name_of(Kind kind);

/// The number of words that the kind takes in a record.
constexpr std::size_t words_of(Kind kind) { return kind < Kind::optional ? 1 : 2; }

/// Whether a value of the kind lies in the family's data.
constexpr bool in_data(Kind kind) { return kind >= Kind::bytes; }

struct Column {
  std::string name;
  Kind kind;
  std::string about;
  std::vector<std::string> names = {};  ///< names for Kind::name and Kind::set
};

/// Records with the same columns.
struct Table {
  std::string name;
  std::string about;
  std::vector<Column> columns;
  std::vector<std::uint32_t> words = {};  ///< the records one after another

  /// The number of words in a record.
  std::size_t stride() const;
  std::size_t records() const { return words.size() / stride(); }
  std::span<const std::uint32_t> record(std::size_t k) const {
    return std::span(words).subspan(k * stride(), stride());
  }
};

/// The tables of one topic.
struct Family {
  std::string name;
  std::uint32_t version;  ///< grows when a vector of the last version changes or goes
  std::string about;
  std::vector<Table> tables = {};
  Bytes data = {};
  std::vector<std::string> abouts = {};
};

/// The longest text in bytes: the binary form stores it with a final 0.
inline constexpr std::size_t longest_about = 63;

}  // namespace mmverify::vectors
