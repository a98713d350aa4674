#include "delivery/vectors/table.hpp"

namespace mmverify::vectors {

const char* name_of(Kind kind) {
  constexpr const char* names[] = {"number", "binary32", "name",   "about", "optional", "wide",
                                   "set",    "bytes",    "digits", "words", "binary32s"};
  return names[static_cast<std::size_t>(kind)];
}

std::size_t Table::stride() const {
  std::size_t sum = 0;
  for (const Column& column : columns) sum += words_of(column.kind);
  return sum;
}

}  // namespace mmverify::vectors
