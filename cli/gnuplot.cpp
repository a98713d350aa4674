#include "cli/gnuplot.hpp"

#include <fmt/format.h>

#include <utility>

#include "cli/exit_code.hpp"
#include "subjects/program/program.hpp"

namespace mmverify::cli {

std::string run_gnuplot(const std::string& script) {
  try {
    program::ProgramEnd end = program::run_program({"gnuplot"}, script);
    if (!end.succeeded || end.out.find("</svg>") == std::string::npos)
      throw EnvironmentError(fmt::format("gnuplot drew nothing: {}", end.errors));
    return std::move(end.out);
  } catch (const program::NoProgram&) {
    throw EnvironmentError("--plot needs gnuplot, which is not here: install the Debian package gnuplot-nox");
  }
}

}  // namespace mmverify::cli
