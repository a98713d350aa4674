// The option --json FILE|-, of every command that has one.
#pragma once

#include <cstdio>
#include <functional>
#include <optional>
#include <string>

#include "cli/output/output_file.hpp"

namespace mmverify::cli {

/// Writes JSON to a file, to stdout for "-", or nowhere for an empty path. Text goes to stdout, or to stderr where
/// JSON takes stdout.
class JsonOutput {
 public:
  /// Opens the file. Errors: as OutputFile's.
  explicit JsonOutput(const std::string& path);

  std::FILE* text() const { return on_stdout_ ? stderr : stdout; }
  bool given() const { return on_stdout_ || file_; }
  /// Removes the file of an earlier run.
  void remove_old() const;
  /// Writes what json() returns, which is called only if JSON is written.
  void write(const std::function<std::string()>& json);

 private:
  bool on_stdout_;
  std::optional<OutputFile> file_;
};

}  // namespace mmverify::cli
