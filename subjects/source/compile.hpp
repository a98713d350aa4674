// Compiles a file of C, C++, bitcode or SPIR-V: to bitcode by clang, to a program at each level, and to a
// shared library.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "subjects/program/folder.hpp"
#include "subjects/program/program.hpp"
#include "subjects/source/errors.hpp"
#include "subjects/source/program.hpp"

namespace mmverify::source {

/// A function in C or C++, in LLVM bitcode (binary or text), or in SPIR-V, compiled.
class Compiled {
 public:
  /// Compiles the file: -O1, no contraction of products and sums, and `flags`. `read`: the file to read
  /// instead if another compiler has made it. `fault`: as for at_level. Throws BadSource, NotAvailable,
  /// UnknownInstruction.
  Compiled(const std::string& file, const std::string& function, const std::vector<std::string>& flags = {},
           const std::string& read = {}, const std::string& fault = {});

  /// The function's program at that level, with calls inlined and loops unrolled. `fault`: a deliberate
  /// mistake of the reader, for a test. Throws UnknownInstruction, BadSource.
  Program at_level(unsigned level, const std::string& fault = {}) const;

  /// A shared library with the interface of subjects/sdk/mmverify_subject.h; its index_f32 is the function.
  const std::string& library() const { return library_; }
  /// The bytes of the bitcode that exports this function alone.
  const std::string& bitcode() const { return exported_; }
  /// The compiler, "clang version 14.0.6"; "SPIR-V" for SPIR-V.
  const std::string& compiler() const { return compiler_; }
  /// The folder of the files; they exist as long as the pointer does.
  std::shared_ptr<const program::Folder> files() const { return folder_; }

 private:
  /// Makes bitcode of the file by clang.
  void compile(const std::vector<std::string>& flags);
  /// Makes the library of the function alone.
  void link(const std::string& fault);
  /// The reader's error message, with the name of the original file.
  std::string said(const program::ProgramEnd& end) const;

  std::string file_, function_, bitcode_, exported_, library_, compiler_;
  std::string shifts_;  ///< the reader's word for how shifts take their amount
  std::shared_ptr<const program::Folder> folder_;
};

}  // namespace mmverify::source
