// The file of --plot.
#pragma once

#include <string>

#include "bench/picture.hpp"
#include "cli/output/output_file.hpp"

namespace mmverify::cli {

/// The picture as a PNG, drawn with gnuplot.  Throws EnvironmentError as PlotFile::commit() does.
std::string plotted_png(const bench::picture::Picture& picture);

/// The check of the name of --plot, for CLI11: a complaint if it ends in neither .svg nor .png, else empty.
std::string plot_name(const std::string& name);

class PlotFile {
 public:
  /// The file at `path`: PNG if the name ends in .png, else SVG; plot_name() has no complaint about it. Errors: as OutputFile.
  explicit PlotFile(const std::string& path);

  /// Draws the picture with gnuplot and writes the file.
  /// Throws EnvironmentError if gnuplot fails, or is missing; the message then names the Debian package.
  void commit(const bench::picture::Picture& picture);

 private:
  OutputFile file_;
  bool is_png_;
};

}  // namespace mmverify::cli
