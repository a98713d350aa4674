// The programs and folders that sources are compiled with.
#pragma once

#include <string>
#include <vector>

#include "subjects/program/folder.hpp"
#include "subjects/program/program.hpp"
#include "subjects/source/errors.hpp"

namespace mmverify::source {

/// The folder of mmverify_subject.h: installed, beside the programs of a tree built by hand, or the sources'.
/// Errors: NotAvailable.
std::string header_folder();

/// The path of a program of ours: the one that the environment's variable names, else the one beside this program, in the
/// installed libexec, or in the folder cli beside this program's, for tests.
/// Errors: NotAvailable, which says that the program is missing: NAME, `lacks`.
std::string helper(const char* variable, const std::string& name, const std::string& lacks);

/// Runs a program for at most 300 s and in at most 8 GiB. Errors: as run_program.
program::ProgramEnd run_tool(const std::vector<std::string>& words);

/// Runs clang, or the compiler that MMVERIFY_CLANG names. Errors: NotAvailable if there is none.
program::ProgramEnd run_clang(std::vector<std::string> words);

/// "clang version 14.0.6".
std::string clang_version();

/// Whether the file's name is that of a source in C++ rather than in C.
bool is_cpp(const std::string& file);

/// Whether the file's name is that of bitcode, binary or as text.
bool is_bitcode(const std::string& file);

/// Whether the file's name is that of a source in Rust.
bool is_rust(const std::string& file);

/// Throws NoSource or BadSource if the file is none that can be read, and UnknownInstruction for a flag that changes what
/// the code means.
void refuse_unfit(const std::string& file, const std::vector<std::string>& flags);

/// Compiles a file of C or C++ with these options to `out`, an object or bitcode, which lies in the folder.
/// Errors: BadSource with the compiler's message; NotAvailable.
void compile_file(const std::string& file, const std::vector<std::string>& options, const std::string& out,
                  const program::Folder& folder);

/// Compiles a file of Rust with these flags of rustc to bitcode with all that it calls, by rustc or the compiler that
/// MMVERIFY_RUSTC names.  Returns "rustc 1.63.0".
/// Errors: BadSource with the compiler's message; NotAvailable if there is none, or clang reads no bitcode of its LLVM.
std::string compile_rust(const std::string& file, const std::vector<std::string>& flags,
                         const std::string& out, const program::Folder& folder);

}  // namespace mmverify::source
