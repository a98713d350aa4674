// From somebody's file to what is judged: bitcode by clang, a program at each level, a shared library to run.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "program/folder.hpp"
#include "program/program.hpp"
#include "source/program.hpp"

namespace mmverify::source {

/// A file that does not compile, or has no such function; what() has the compiler's own words.
struct BadSource : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// No clang, or no reader of bitcode in this build; what() names the tool and its package.
struct NotAvailable : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// An instruction that has no operation here; what() begins with file and line.
struct UnknownInstruction : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A function of a file in C or C++, or of LLVM's bitcode or its text, or of SPIR-V.
class Compiled {
 public:
  /// Compiles it: -O1, no contraction of products and sums, and `flags`.  `read`: what is read in its place, where another
  /// compiler has made it.  `fault`: as of at_level.  Throws BadSource, NotAvailable, UnknownInstruction.
  Compiled(const std::string& file, const std::string& function, const std::vector<std::string>& flags = {},
           const std::string& read = {}, const std::string& fault = {});

  /// What it is at that level, its calls inlined and its loops unrolled.  `fault`: a mistake of the reader on purpose,
  /// for a test.  Throws UnknownInstruction, BadSource.
  Program at_level(unsigned level, const std::string& fault = {}) const;

  /// A shared library behind sdk/mmverify_subject.h, whose index_f32 is the function.
  const std::string& library() const { return library_; }
  /// The bytes of the bitcode with that function alone for others to call.
  const std::string& bitcode() const { return exported_; }
  /// "clang version 14.0.6"; of SPIR-V "SPIR-V".
  const std::string& compiler() const { return compiler_; }
  /// Keeps the files of both as long as it is there.
  std::shared_ptr<const program::Folder> files() const { return folder_; }

 private:
  /// The reader's complaint, about the file that was named.
  std::string said(const program::ProgramEnd& end) const;

  std::string file_, function_, bitcode_, exported_, library_, compiler_;
  std::shared_ptr<const program::Folder> folder_;
};

}  // namespace mmverify::source
