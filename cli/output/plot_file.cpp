#include "cli/output/plot_file.hpp"

#include <fmt/format.h>

#include "cli/bench/plot.hpp"
#include "cli/output/exit_code.hpp"
#include "subjects/program/program.hpp"

namespace mmverify::cli {
namespace {

/// The output of gnuplot for a script that writes to standard output.
std::string run_gnuplot(const std::string& script, const char* end_of_picture) {
  try {
    program::ProgramEnd end = program::run_program({"gnuplot"}, script);
    if (!end.succeeded || end.out.find(end_of_picture) == std::string::npos)
      throw EnvironmentError(fmt::format("gnuplot drew nothing: {}", end.errors));
    return std::move(end.out);
  } catch (const program::NoProgram&) {
    throw EnvironmentError("a plot needs gnuplot, which is not here: install the Debian package gnuplot-nox");
  }
}

}  // namespace

std::string plotted_png(const bench::picture::Picture& picture) {
  return run_gnuplot(plot_script(picture, PlotFormat::png), "IEND");
}

std::string plot_name(const std::string& name) {
  return name.ends_with(".svg") || name.ends_with(".png")
             ? ""
             : fmt::format("{:.200}: plots are SVG or PNG; name it .svg or .png", name);
}

PlotFile::PlotFile(const std::string& path) : file_(path), is_png_(path.ends_with(".png")) {}

void PlotFile::commit(const bench::picture::Picture& picture) {
  file_.commit(is_png_ ? plotted_png(picture) : run_gnuplot(plot_script(picture, PlotFormat::svg), "</svg>"));
}

}  // namespace mmverify::cli
