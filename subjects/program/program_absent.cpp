// Replaces program.cpp on platforms without processes, such as WebAssembly.
#include "subjects/program/program.hpp"

namespace mmverify::program {

ProgramEnd run_program(const std::vector<std::string>& arguments, const std::string&,
                       const std::function<void()>&, const Bounds&) {
  throw NoProgram(arguments.at(0) +
                  ": other programs cannot be run from WebAssembly; the native mmverify does");
}

}  // namespace mmverify::program
