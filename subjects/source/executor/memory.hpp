// Memory of a program that runs on all inputs at once: objects of bytes, each the byte of a value.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "subjects/source/executor/value.hpp"

namespace mmverify::source::executor {

/// A byte of a value; no value: nobody wrote it.
struct Cell {
  ValuePtr value;
  std::uint8_t byte = 0;
};

struct Object {
  std::string name;
  std::vector<Cell> cells;
  Word size;                ///< where the size depends on the inputs: it, of 64 bits; else empty
  Literal gone = never;     ///< it is freed, or its block has ended
  int call = 0;             ///< the call whose variable it is; 0: of none
  std::uint64_t align = 1;  ///< its address is a multiple of it
  /// A law's variable: an entry point may rely on no more than this alignment; 0: on `align`.
  std::uint64_t promised = 0;
  bool constant = false;  ///< no program may write it
  bool lasting = false;   ///< it is a global variable
  /// The places of the cells, if the content of all other bytes is any at each read; else empty.
  std::vector<Word> watched;
};

/// The bytes of a value, as memory has it.
std::size_t bytes_of(const Value& v);
/// The value of `bytes` bytes at `at`. A value that was stored whole is the same value; a part of a pointer is a
/// pointer that no program may use.
ValuePtr loaded(const Object& object, std::size_t at, std::size_t bytes);
void store(Object& object, std::size_t at, const ValuePtr& value);
/// `bytes` bytes that nobody wrote.
void forget(Object& object, std::size_t at, std::size_t bytes);

class Memory {
 public:
  void add(int number, Object object);
  const Object* find(int number) const;
  /// The object, no other memory's.
  Object& writable(int number);
  /// Drops the variables of a call.
  void drop(int call);
  /// This memory where `when` does not hold, the other one where it does.
  void choose(Graph& g, Literal when, const Memory& other);

 private:
  using Entry = std::pair<int, std::shared_ptr<Object>>;
  std::vector<Entry> objects_;  ///< by number, rising
};

}  // namespace mmverify::source::executor
