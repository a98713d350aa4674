#include "subjects/source/compile.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "subjects/program/program.hpp"
#include "subjects/source/flags.hpp"

namespace mmverify::source {

namespace fs = std::filesystem;

namespace {

using program::ProgramEnd;

constexpr const char* behind_the_header = R"(#include <mmverify_subject.h>
uint32_t mmverify_source_index(uint32_t level, float u, float v);
static void index_f32(uint32_t level, const float* u, const float* v, uint32_t* index, size_t count) {
  for (size_t k = 0; k < count; ++k) index[k] = mmverify_source_index(level, u[k], v[k]);
}
const mmverify_subject_t* mmverify_subject_v1(void) {
  static const mmverify_subject_t subject = {
      .abi = MMVERIFY_SUBJECT_ABI, .size = sizeof subject, .max_level = 16, .index_f32 = index_f32};
  return &subject;
}
)";

fs::path program_folder() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path();
}

/// The folder of mmverify_subject.h: installed, beside the programs of a tree built by hand, or the sources'.
std::string header_folder() {
  const fs::path here = program_folder();
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

std::string clang() {
  const char* named = std::getenv("MMVERIFY_CLANG");
  return named != nullptr ? named : "clang";
}

/// The reader's path: beside the program, in the installed libexec, or in the folder cli beside the
/// program's, for tests.
std::string reader() {
  if (const char* named = std::getenv("MMVERIFY_SOURCE_READER")) return named;
  std::error_code error;
  const fs::path here = program_folder();
  for (const fs::path& place : {here / "mmverify-source", here / "../libexec/mmverify/mmverify-source",
                                here / "../cli/mmverify-source"})
    if (fs::exists(place, error)) return place.string();
  throw NotAvailable(
      "mmverify-source, which reads LLVM's bitcode, is missing in this build; install LLVM (Debian: "
      "llvm-14-dev) and build again (./run build does both)");
}

ProgramEnd ended(const std::vector<std::string>& words) {
  using std::chrono_literals::operator""s;
  return program::run_program(words, {}, {}, {300s, std::uint64_t{8} << 30, std::uint64_t{256} << 20});
}

ProgramEnd of_clang(std::vector<std::string> words) {
  words.insert(words.begin(), clang());
  try {
    return ended(words);
  } catch (const program::NoProgram&) {
    throw NotAvailable(
        clang() +
        ": there is no such compiler; install it (Debian: clang), or name another by MMVERIFY_CLANG");
  }
}

ProgramEnd of_reader(std::vector<std::string> words) {
  words.insert(words.begin(), reader());
  try {
    return ended(words);
  } catch (const program::NoProgram& why) {
    throw NotAvailable(why.what());
  }
}

/// Throws BadSource if spirv-val refuses the module: the reader assumes a valid one. Without spirv-val,
/// nothing is checked.
void check(const std::string& spirv, const std::string& file) {
  try {
    if (const ProgramEnd end = ended({"spirv-val", spirv}); !end.succeeded)
      throw BadSource(file + ": spirv-val: " + program::one_line(end.out + end.errors));
  } catch (const program::NoProgram&) {
  }
}

/// The languages that clang is to take a file for, in turn; empty: the one that its name tells. clang would take a
/// header alone for one to precompile.
std::vector<std::string> languages_of(const std::string& file) {
  const std::string extension = fs::path(file).extension().string();
  if (extension == ".h") return {"c", "c++"};
  if (extension == ".hpp") return {"c++"};
  return {""};
}

std::string bytes_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

Compiled::Compiled(const std::string& file, const std::string& function,
                   const std::vector<std::string>& flags, const std::string& read, const std::string& fault)
    : file_(file),
      function_(function),
      bitcode_(read.empty() ? file : read),
      folder_(std::make_shared<const program::Folder>("source")) {
  reader();
  std::error_code error;
  if (!fs::exists(file, error)) throw NoSource(file + ": no such file");
  if (!fs::is_regular_file(file, error)) throw BadSource(file + ": it is no file with text or code");
  for (const std::string& flag : flags)
    if (const auto why = why_not_judged(flag))
      throw UnknownInstruction(file + ": --flag=" + flag + ": " + *why);
  const std::string version = of_clang({"--version"}).out;
  const std::size_t from = version.find("clang version");
  compiler_ = from == std::string::npos
                  ? "clang"
                  : version.substr(from, version.find_first_of(" \n(", from + 14) - from);
  const std::string extension = fs::path(bitcode_).extension().string();
  if (extension == ".spv") {
    check(bitcode_, file);
    // A copy of the file: what is judged is what was read, even if the file changes.
    const std::string kept = folder_->file("module.spv");
    fs::copy_file(bitcode_, kept, fs::copy_options::overwrite_existing);
    bitcode_ = kept;
    compiler_ = "SPIR-V";
  } else if (extension != ".bc" && extension != ".ll") {
    compile(flags);
  }
  shifts_ = fs::path(file).extension() == ".hlsl" ? "hlsl" : "other";
  link(fault);
}

void Compiled::compile(const std::vector<std::string>& flags) {
  static const std::array known{".c", ".h", ".cc", ".cpp", ".cxx", ".hpp", ".C", ".i", ".ii"};
  if (std::find(known.begin(), known.end(), fs::path(file_).extension().string()) == known.end())
    throw BadSource(file_ +
                    ": its name tells no language; .c, .cpp, .glsl, .comp, .hlsl, .spv, .bc and .ll do");
  bitcode_ = folder_->file("module.bc");
  // clang must report a constant index beyond an array's end: in the bitcode it is an index into the next
  // row. LLVM's passes are left to the reader. Functions without a caller are kept.
  std::vector<std::string> words{
      "-O1", "-g", "-Xclang", "-disable-llvm-passes", "-Xclang", "-femit-all-decls", "-I" + header_folder()};
  words.insert(words.end(), flags.begin(), flags.end());
  words.insert(words.end(), {"-fno-caret-diagnostics", "-Werror=array-bounds", "-ffp-contract=off",
                             "-fno-math-errno", "-emit-llvm", "-c", "-o", bitcode_});
  ProgramEnd end;
  for (const std::string& language : languages_of(file_)) {
    std::vector<std::string> all = words;
    if (!language.empty()) all.insert(all.end(), {"-x", language});
    all.insert(all.end(), {"--", file_});
    end = of_clang(all);
    if (end.succeeded) return;
  }
  folder_->check_room();
  throw BadSource(file_ + ": clang does not compile it (" + end.how + "): " + program::one_line(end.errors));
}

void Compiled::link(const std::string& fault) {
  const std::string alone = folder_->file("index.bc"), wrapper = folder_->file("subject.c");
  const ProgramEnd end =
      of_reader({bitcode_, function_, "export", alone, fault.empty() ? "none" : fault, shifts_});
  if (!end.succeeded) folder_->check_room();
  if (end.how == "exit code 3") throw UnknownInstruction(said(end));
  if (!end.succeeded) throw BadSource(file_ + ": " + said(end));
  exported_ = bytes_of(alone);
  std::ofstream(wrapper) << behind_the_header;
  library_ = folder_->file("index.so");
  const ProgramEnd linked =
      of_clang({"-O1", "-ffp-contract=off", "-fno-math-errno", "-Wno-override-module", "-shared", "-fPIC",
                "-I" + header_folder(), wrapper, alone, "-lm", "-o", library_});
  if (!linked.succeeded) folder_->check_room();
  if (!linked.succeeded)
    throw BadSource(file_ + ": clang makes no shared library of it (" + linked.how +
                    "): " + program::one_line(linked.errors));
}

std::string Compiled::said(const program::ProgramEnd& end) const {
  std::string text = program::one_line(end.errors);
  if (const std::size_t at = text.find(bitcode_); at != std::string::npos)
    text.replace(at, bitcode_.size(), file_);
  return text;
}

Program Compiled::at_level(unsigned level, const std::string& fault) const {
  const ProgramEnd read =
      of_reader({bitcode_, function_, std::to_string(level), fault.empty() ? "none" : fault, shifts_});
  if (read.how == "exit code 3") throw UnknownInstruction(said(read));
  if (!read.succeeded) throw BadSource(file_ + ": mmverify-source: " + read.how + ": " + said(read));
  return read_program(read.out);
}

}  // namespace mmverify::source
