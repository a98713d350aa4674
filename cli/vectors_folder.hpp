// A folder of vectors, written whole or not at all.
#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>

#include "vectors/forms/forms.hpp"

namespace mmverify::cli {

/// Where vectors go: a folder that is not there, is empty, or has what an earlier run wrote and nothing else.  They are
/// written into a folder beside it, which goes with this.
class VectorsFolder {
 public:
  /// Errors: EnvironmentError, naming the folder, where it is no folder, has anything else, or cannot be written.
  explicit VectorsFolder(const std::string& asked);
  ~VectorsFolder();
  VectorsFolder(const VectorsFolder&) = delete;
  VectorsFolder& operator=(const VectorsFolder&) = delete;

  /// Puts the files in place, the last of them last: a folder that is new appears whole; in one that is there the
  /// manifest goes first and comes last, so that it stands for whole vectors alone, and files of it that are no longer
  /// among them go.
  /// Errors: EnvironmentError.
  void commit(std::span<const vectors::File> files);

 private:
  std::string asked_;
  std::filesystem::path folder_, stage_;
  std::set<std::string> before_;
  int lock_ = -1;  ///< the stage's
};

}  // namespace mmverify::cli
