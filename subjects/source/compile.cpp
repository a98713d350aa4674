#include "subjects/source/compile.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "subjects/program/program.hpp"
#include "subjects/source/tools.hpp"

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

/// The reader's path.
std::string reader() {
  return helper("MMVERIFY_SOURCE_READER", "mmverify-source",
                "which reads LLVM's bitcode, is missing; install the release's Debian package "
                "mmverify-plugins, or, where you "
                "build the sources, llvm-14-dev, and build again (./run build does both)");
}

ProgramEnd of_reader(std::vector<std::string> words) {
  words.insert(words.begin(), reader());
  try {
    return run_tool(words);
  } catch (const program::NoProgram& why) {
    throw NotAvailable(why.what());
  }
}

/// Throws BadSource if spirv-val refuses the module: the reader assumes a valid one. Without spirv-val,
/// nothing is checked.
void check(const std::string& spirv, const std::string& file) {
  try {
    if (const ProgramEnd end = run_tool({"spirv-val", spirv}); !end.succeeded)
      throw BadSource(file + ": spirv-val: " + program::one_line(end.out + end.errors));
  } catch (const program::NoProgram&) {
  }
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
  refuse_unfit(file, flags);
  compiler_ = clang_version();
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
  bitcode_ = folder_->file("module.bc");
  // clang must report a constant index beyond an array's end: in the bitcode it is an index into the next
  // row. LLVM's passes are left to the reader. Functions without a caller are kept.
  std::vector<std::string> words{
      "-O1", "-g", "-Xclang", "-disable-llvm-passes", "-Xclang", "-femit-all-decls"};
  words.insert(words.end(), flags.begin(), flags.end());
  words.insert(words.end(), {"-Werror=array-bounds", "-ffp-contract=off", "-fno-math-errno", "-emit-llvm"});
  compile_file(file_, words, bitcode_, *folder_);
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
      run_clang({"-O1", "-ffp-contract=off", "-fno-math-errno", "-Wno-override-module", "-shared", "-fPIC",
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
