// A value of a program that runs on all inputs at once: a number, a pointer or a struct, made of a graph's literals.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "subjects/source/circuit/word.hpp"

namespace mmverify::source::executor {

using circuit::always;
using circuit::Graph;
using circuit::Literal;
using circuit::negated;
using circuit::never;
using circuit::Word;

inline constexpr std::size_t pointer_bits = 64;

struct Value;
using ValuePtr = std::shared_ptr<const Value>;

/// Targets of a pointer that are no object of memory.
inline constexpr int null_object = -1, unset_object = -2, number_object = -3;

/// A pointer into one object, if `when` holds; the conditions of a pointer's targets exclude each other.
struct Target {
  Literal when;
  int object;
  Word offset;
};

struct Value {
  enum class Kind { number, pointer, parts } kind = Kind::number;
  Word bits;                    ///< of a number
  Word unset;                   ///< bits that were never set; empty: all are set
  std::vector<Target> targets;  ///< of a pointer
  std::vector<ValuePtr> parts;  ///< of a struct or an array in a register
};

ValuePtr number(Word bits, Word unset = {});
ValuePtr number(std::uint64_t value, std::size_t width);
ValuePtr unset_number(std::size_t width);
ValuePtr pointer(int object, std::uint64_t offset = 0);
ValuePtr parts(std::vector<ValuePtr> parts);

inline bool is_pointer(const ValuePtr& v) { return v->kind == Value::Kind::pointer; }
/// The number, if no input changes it and all its bits are set.
std::optional<std::uint64_t> known(const ValuePtr& v);
/// The unset bits, one literal a bit.
Word unset_bits(const Value& v);

/// a where `when` holds, else b. A number and a pointer make a pointer that no program may use.
ValuePtr chosen(Graph& g, Literal when, const ValuePtr& a, const ValuePtr& b);

}  // namespace mmverify::source::executor
