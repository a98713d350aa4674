// The symbols that a library's file defines.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace mmverify::dock {

/// Names in the order of the file. exported: other programs find them. hidden: the library alone finds them; a
/// stripped library has none.
struct ElfSymbols {
  std::vector<std::string> exported, hidden;
};

/// Reads the symbol tables of a 64-bit ELF file of this machine's byte order. Empty if the file cannot be read, is
/// no such file, or contradicts itself.
/// Source: System V ABI, "Symbol Table"; <elf.h>.
std::optional<ElfSymbols> elf_symbols(const std::string& file);

}  // namespace mmverify::dock
