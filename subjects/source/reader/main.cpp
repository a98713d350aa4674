// mmverify-source: reads LLVM bitcode or SPIR-V and writes a program of subjects/source/program.hpp. It is a process
// of its own, so that no other process contains LLVM, and bitcode that crashes LLVM ends nothing else.
//
//   mmverify-source FILE FUNCTION LEVEL [FAULT [hlsl]]   the program, to standard output
//   mmverify-source FILE FUNCTION export OUT.bc [FAULT [hlsl]]   writes bitcode that exports that function
// hlsl: SPIR-V made of HLSL, which shifts by the amount modulo the width.
// Exit codes: 0; 2 a bad file, no such function, or one of another form; 3 an unknown instruction; 4 any
// other error.
#include <llvm/Bitcode/BitcodeWriter.h>
#include <llvm/IR/DiagnosticInfo.h>
#include <llvm/Support/CommandLine.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/raw_ostream.h>

#include <array>
#include <cstdio>
#include <string>

#include "subjects/source/reader/module.hpp"
#include "subjects/source/reader/refused/refused.hpp"

namespace {

using namespace mmverify::source;

constexpr std::array faults{
    "none",        "swapped-edges",      "signed-compare", "shift-by-one-less",  "widened-with-sign",
    "lost-wrap",   "shuffled-otherwise", "signed-numbers", "lowest-for-highest", "clamped-above-alone",
    "table-of-one"};

Planted planted_by(const std::string& word) {
  for (std::size_t k = 0; k < faults.size(); ++k)
    if (word == faults[k]) return static_cast<Planted>(k);
  throw CannotRead("no fault is called '" + word + "'");
}

void say(const std::exception& why) { std::fprintf(stderr, "%s\n", why.what()); }

int run(int count, char** words) {
  if (count < 4) {
    std::fputs(
        "usage: mmverify-source FILE FUNCTION LEVEL [FAULT [hlsl]]\n       mmverify-source FILE FUNCTION "
        "export OUT.bc [FAULT [hlsl]]\n",
        stderr);
    return 2;
  }
  const std::string file = words[1], name = words[2], what = words[3];
  const bool exports = what == "export";
  const int last = exports ? 5 : 4;
  const Planted planted = planted_by(count > last ? words[last] : "none");
  const bool shifts_wrap = count > last + 1 && words[last + 1] == std::string("hlsl");
  llvm::LLVMContext context;
  const std::unique_ptr<llvm::Module> module = read_module(file, name, context, planted, shifts_wrap);
  llvm::Function& index = index_function(*module, name);
  if (exports) {
    refuse_what_is_not_judged(*module, index);
    export_index(*module, index);
    std::error_code error;
    llvm::raw_fd_ostream out(count > 4 ? words[4] : "-", error);
    if (error) throw CannotRead(error.message());
    llvm::WriteBitcodeToFile(*module, out);
    return 0;
  }
  // Loops are unrolled whatever their size.
  const char* options[] = {"mmverify-source", "-unroll-threshold=1000000", "-unroll-full-max-count=4096",
                           "-unroll-max-iteration-count-to-analyze=4096"};
  llvm::cl::ParseCommandLineOptions(std::size(options), options);
  const llvm::Function& f = at_level(*module, index, static_cast<unsigned>(std::stoul(what)));
  if (std::getenv("MMVERIFY_SOURCE_IR") != nullptr) f.print(llvm::errs());
  const std::string text = to_text(translate(f, planted));
  std::fwrite(text.data(), 1, text.size(), stdout);
  return 0;
}

}  // namespace

int main(int count, char** words) {
  try {
    return run(count, words);
  } catch (const NotKnown& why) {
    say(why);
    return 3;
  } catch (const CannotRead& why) {
    say(why);
    return 2;
  } catch (const std::exception& why) {
    say(why);
    return 4;
  }
}
