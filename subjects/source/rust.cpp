// Rust to bitcode.
#include <cstdlib>

#include "subjects/source/tools.hpp"

namespace mmverify::source {
namespace {

using program::ProgramEnd;

std::string rustc() {
  const char* named = std::getenv("MMVERIFY_RUSTC");
  return named != nullptr ? named : "rustc";
}

ProgramEnd run_rustc(std::vector<std::string> words) {
  words.insert(words.begin(), rustc());
  try {
    return run_tool(words);
  } catch (const program::NoProgram&) {
    throw NotAvailable(
        rustc() +
        ": there is no such compiler; install it (Debian: rustc), or name another by MMVERIFY_RUSTC");
  }
}

/// The word after `begins`, up to the end of its line; empty if there is none.
std::string word_after(const std::string& text, const std::string& begins) {
  const std::size_t at = text.find(begins);
  if (at == std::string::npos) return {};
  const std::size_t from = at + begins.size();
  return text.substr(from, text.find_first_of(" \n", from) - from);
}

int major_of(const std::string& version) { return std::atoi(version.c_str()); }

}  // namespace

std::string compile_rust(const std::string& file, const std::vector<std::string>& flags,
                         const std::string& out, const program::Folder& folder) {
  const std::string version = run_rustc({"--version", "--verbose"}).out;
  const std::string release = word_after(version, "release: "), llvm = word_after(version, "LLVM version: ");
  const std::string clang = clang_version(), of_clang = word_after(clang, "clang version ");
  if (major_of(llvm) > major_of(of_clang))
    throw NotAvailable(
        rustc() + " " + release + " makes bitcode of LLVM " + llvm + ", which " + clang +
        " cannot read; name one of an older LLVM by MMVERIFY_RUSTC (Debian 12: /usr/bin/rustc)");
  // One module with all that the codec calls; a panic ends the program, and sums wrap as in C's unsigned numbers.
  std::vector<std::string> words{"--edition=2021", "--crate-type=staticlib", "--emit=llvm-bc", "-g"};
  for (const char* option : {"lto=fat", "opt-level=1", "panic=abort", "overflow-checks=off"})
    words.insert(words.end(), {"-C", option});
  words.insert(words.end(), flags.begin(), flags.end());
  words.insert(words.end(), {"-o", out, file});
  const ProgramEnd end = run_rustc(words);
  if (end.succeeded) return "rustc " + release;
  folder.check_room();
  throw BadSource(file + ": rustc does not compile it (" + end.how + "): " + program::one_line(end.errors));
}

}  // namespace mmverify::source
