// Programs of others that make or read shaders, and the folder in which they do.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "program/program.hpp"

namespace mmverify::shaders {

/// None where there is no such program.  A compiler takes a second; a file that includes itself would keep it for ever.
std::optional<program::ProgramEnd> ended(const std::vector<std::string>& words);

/// Errors: std::runtime_error that names the file.
std::string contents_of(const std::string& file);
void write_file(const std::string& file, const std::string& text);

/// A folder of its own, removed with this.  A process that is killed leaves its folder behind: the next folder that is
/// made removes those of processes that have ended.  A folder is its process's as long as that holds a lock on it.
class Folder {
 public:
  /// Errors: std::runtime_error where it cannot be made.
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const;

 private:
  std::string path_;
  int lock_ = -1;
};

}  // namespace mmverify::shaders
