#include "subjects/source/tools.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "subjects/program/own_folder.hpp"
#include "subjects/source/flags.hpp"

namespace mmverify::source {

namespace fs = std::filesystem;

namespace {

using program::ProgramEnd;

std::string clang() {
  const char* named = std::getenv("MMVERIFY_CLANG");
  return named != nullptr ? named : "clang";
}

/// The languages that clang is to take a file for, in turn; empty: the one that its name tells. clang would take a
/// header alone for one to precompile.
std::vector<std::string> languages_of(const std::string& file) {
  const std::string extension = fs::path(file).extension().string();
  if (extension == ".h") return {"c", "c++"};
  if (extension == ".hpp") return {"c++"};
  return {""};
}

template <std::size_t count>
bool ends_in_one_of(const std::string& file, const std::array<const char*, count>& extensions) {
  return std::find(extensions.begin(), extensions.end(), fs::path(file).extension().string()) !=
         extensions.end();
}

}  // namespace

std::string header_folder() {
  const fs::path here = program::own_folder();
  std::error_code error;
  std::string tried;
  for (const fs::path& folder : {here / "../include", here / "../sdk", fs::path(MMVERIFY_SDK)}) {
    const std::string place = folder.lexically_normal().string();
    if (fs::exists(folder / "mmverify_subject.h", error)) return place;
    tried += (tried.empty() ? "" : ", ") + place;
  }
  throw NotAvailable("mmverify_subject.h, which a source is compiled with, is in none of " + tried +
                     "; put it into one of them (it is subjects/sdk/mmverify_subject.h)");
}

std::string helper(const char* variable, const std::string& name, const std::string& lacks) {
  if (const char* named = std::getenv(variable)) return named;
  std::error_code error;
  const fs::path here = program::own_folder();
  for (const fs::path& place : {here / name, here / "../libexec/mmverify" / name, here / "../cli" / name})
    if (fs::exists(place, error)) return place.string();
  throw NotAvailable(name + ", " + lacks);
}

ProgramEnd run_tool(const std::vector<std::string>& words) {
  using std::chrono_literals::operator""s;
  return program::run_program(words, {}, {}, {300s, std::uint64_t{8} << 30, std::uint64_t{256} << 20});
}

ProgramEnd run_clang(std::vector<std::string> words) {
  words.insert(words.begin(), clang());
  try {
    return run_tool(words);
  } catch (const program::NoProgram&) {
    throw NotAvailable(
        clang() +
        ": there is no such compiler; install it (Debian: clang), or name another by MMVERIFY_CLANG");
  }
}

std::string clang_version() {
  const std::string version = run_clang({"--version"}).out;
  const std::size_t from = version.find("clang version");
  return from == std::string::npos ? "clang"
                                   : version.substr(from, version.find_first_of(" \n(", from + 14) - from);
}

bool is_cpp(const std::string& file) {
  static constexpr std::array extensions{".cc", ".cpp", ".cxx", ".hpp", ".C", ".ii"};
  return ends_in_one_of(file, extensions);
}

bool is_bitcode(const std::string& file) {
  static constexpr std::array extensions{".bc", ".ll"};
  return ends_in_one_of(file, extensions);
}

bool is_rust(const std::string& file) { return fs::path(file).extension() == ".rs"; }

void refuse_unfit(const std::string& file, const std::vector<std::string>& flags) {
  std::error_code error;
  if (!fs::exists(file, error)) throw NoSource(file + ": no such file");
  if (!fs::is_regular_file(file, error)) throw BadSource(file + ": it is no file with text or code");
  for (const std::string& flag : flags)
    if (const auto why = why_not_judged(flag))
      throw UnknownInstruction(file + ": --flag=" + flag + ": " + *why);
}

void compile_file(const std::string& file, const std::vector<std::string>& options, const std::string& out,
                  const program::Folder& folder) {
  static constexpr std::array in_c{".c", ".h", ".i"};
  if (!is_cpp(file) && !is_bitcode(file) && !ends_in_one_of(file, in_c))
    throw BadSource(file +
                    ": its name tells no language; .c, .cpp, .glsl, .comp, .hlsl, .spv, .bc and .ll do, and "
                    ".rs of a codec");
  ProgramEnd end;
  for (const std::string& language : languages_of(file)) {
    std::vector<std::string> words{"-I" + header_folder(), "-Wno-unused-command-line-argument"};
    words.insert(words.end(), options.begin(), options.end());
    words.insert(words.end(), {"-fno-caret-diagnostics", "-c", "-o", out});
    if (!language.empty()) words.insert(words.end(), {"-x", language});
    words.insert(words.end(), {"--", file});
    end = run_clang(words);
    if (end.succeeded) return;
  }
  folder.check_room();
  throw BadSource(file + ": clang does not compile it (" + end.how + "): " + program::one_line(end.errors));
}

}  // namespace mmverify::source
