// Files that are whole or not there.
#pragma once

#include <string>

namespace mmverify::cli {

/// A file that appears under its name only when commit() has written all of it. Opened at once, so that a
/// place that cannot be written is known before hours of work; EnvironmentError names the file.
class OutputFile {
 public:
  explicit OutputFile(std::string path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Writes the text, syncs it and moves it into place.
  void commit(const std::string& text);

 private:
  std::string path_, temporary_;
  int descriptor_ = -1;
};

}  // namespace mmverify::cli
