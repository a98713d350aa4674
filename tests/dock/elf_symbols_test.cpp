// The symbols of a library's file: exported and hidden ones; files that are cut short or contradict themselves.
#include "subjects/dock/elf_symbols.hpp"

#include <elf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <fstream>

#include "tests/folder.hpp"

namespace mmverify::tests {
namespace elf_symbols_test {
namespace {

using testing::Contains;
using testing::Not;

std::string example() { return std::string(MMVERIFY_SUBJECTS) + "/example.so"; }

// The example's functions but its entry point are static.
TEST(ElfSymbols, TellExportedFromHiddenOnes) {
  const auto symbols = dock::elf_symbols(example());
  ASSERT_TRUE(symbols);
  EXPECT_THAT(symbols->exported, Contains("mmverify_subject_v1"));
  EXPECT_THAT(symbols->exported, Not(Contains("index_f32")));
  EXPECT_THAT(symbols->hidden, Contains("index_f32"));
  EXPECT_THAT(symbols->hidden, Not(Contains("mmverify_subject_v1")));
}

TEST(ElfSymbols, OfOtherFilesThereAreNone) {
  const Folder folder;
  const std::string file = folder / "other";
  EXPECT_FALSE(dock::elf_symbols(folder / "missing"));
  for (const char* text : {"",
                           "\x7f"
                           "ELF",
                           "#!/bin/sh\necho this is no library, and longer than its header has to be\n"}) {
    std::ofstream(file, std::ios::binary) << text;
    EXPECT_FALSE(dock::elf_symbols(file)) << text;
  }
}

// The sections lie at the end of the file.
TEST(ElfSymbols, ACutFileHasNone) {
  const std::string whole = text_of(example());
  const Folder folder;
  const std::string file = folder / "cut.so";
  for (std::size_t size = 0; size < whole.size(); size += size < 200 ? 1 : 997) {
    std::ofstream(file, std::ios::binary).write(whole.data(), static_cast<std::streamsize>(size));
    EXPECT_FALSE(dock::elf_symbols(file)) << size << " bytes";
  }
}

// Each offset and size of the tables, set to the greatest number: no read outside of the file.
TEST(ElfSymbols, AFileThatContradictsItselfIsReadWithinItsBytes) {
  const std::string whole = text_of(example());
  Elf64_Ehdr header;
  std::memcpy(&header, whole.data(), sizeof header);
  const Folder folder;
  const std::string file = folder / "wrong.so";
  for (std::size_t k = 0; k < header.e_shnum; ++k)
    for (const std::size_t field : {offsetof(Elf64_Shdr, sh_offset), offsetof(Elf64_Shdr, sh_size)})
      for (const std::uint64_t value :
           {~std::uint64_t{0}, std::uint64_t{whole.size()}, ~std::uint64_t{0} - 23}) {
        std::string wrong = whole;
        std::memcpy(wrong.data() + header.e_shoff + k * sizeof(Elf64_Shdr) + field, &value, sizeof value);
        std::ofstream(file, std::ios::binary) << wrong;
        const auto symbols = dock::elf_symbols(file);
        EXPECT_LE(symbols ? symbols->exported.size() + symbols->hidden.size() : 0, whole.size());
      }
}

}  // namespace
}  // namespace elf_symbols_test
}  // namespace mmverify::tests
