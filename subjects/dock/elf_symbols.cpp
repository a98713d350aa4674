#include "subjects/dock/elf_symbols.hpp"

#include <elf.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <iterator>

namespace mmverify::dock {
namespace {

using Bytes = std::vector<char>;

/// The record at an offset; empty if it does not lie within the bytes.
template <class Record>
std::optional<Record> record_at(const Bytes& bytes, std::uint64_t offset) {
  if (bytes.size() < sizeof(Record) || offset > bytes.size() - sizeof(Record)) return std::nullopt;
  Record record;
  std::memcpy(&record, bytes.data() + offset, sizeof record);
  return record;
}

/// The text at an offset of a string table; empty if it does not lie within the bytes.
std::string text_at(const Bytes& bytes, const Elf64_Shdr& table, std::uint64_t offset) {
  if (table.sh_offset >= bytes.size() || offset >= bytes.size() - table.sh_offset) return {};
  const char* const first = bytes.data() + table.sh_offset + offset;
  const char* const end = bytes.data() + bytes.size();
  return {first, std::find(first, end, '\0')};
}

bool is_exported(const Elf64_Sym& symbol) {
  const auto binding = ELF64_ST_BIND(symbol.st_info), visibility = ELF64_ST_VISIBILITY(symbol.st_other);
  return (binding == STB_GLOBAL || binding == STB_WEAK || binding == STB_GNU_UNIQUE) &&
         (visibility == STV_DEFAULT || visibility == STV_PROTECTED);
}

/// Adds the defined symbols of a section, if it is a symbol table. False if it contradicts itself.
bool add_symbols(const Bytes& bytes, const Elf64_Ehdr& header, const Elf64_Shdr& section,
                 ElfSymbols& symbols) {
  if (section.sh_type != SHT_DYNSYM && section.sh_type != SHT_SYMTAB) return true;
  const auto names =
      record_at<Elf64_Shdr>(bytes, header.e_shoff + std::uint64_t{section.sh_link} * sizeof(Elf64_Shdr));
  if (!names || section.sh_size > bytes.size()) return false;
  for (std::uint64_t at = 0; at + sizeof(Elf64_Sym) <= section.sh_size; at += sizeof(Elf64_Sym)) {
    const auto symbol = record_at<Elf64_Sym>(bytes, section.sh_offset + at);
    if (!symbol) return false;
    if (symbol->st_shndx == SHN_UNDEF) continue;
    const bool is_dynamic = section.sh_type == SHT_DYNSYM;
    if (is_dynamic == is_exported(*symbol))
      (is_dynamic ? symbols.exported : symbols.hidden).push_back(text_at(bytes, *names, symbol->st_name));
  }
  return true;
}

}  // namespace

std::optional<ElfSymbols> elf_symbols(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const Bytes bytes{std::istreambuf_iterator<char>(in), {}};
  const auto header = record_at<Elf64_Ehdr>(bytes, 0);
  constexpr unsigned char order = std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;
  if (!header || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0 ||
      header->e_ident[EI_CLASS] != ELFCLASS64 || header->e_ident[EI_DATA] != order ||
      header->e_shoff > bytes.size())
    return std::nullopt;
  ElfSymbols symbols;
  for (std::uint64_t k = 0; k < header->e_shnum; ++k) {
    const auto section = record_at<Elf64_Shdr>(bytes, header->e_shoff + k * sizeof(Elf64_Shdr));
    if (!section || !add_symbols(bytes, *header, *section, symbols)) return std::nullopt;
  }
  return symbols;
}

}  // namespace mmverify::dock
