// Writes a folder of vectors whole or not at all.
#pragma once

#include <filesystem>
#include <set>
#include <span>
#include <string>

#include "delivery/vectors/forms/forms.hpp"

namespace mmverify::cli {

/// An output folder for vectors: it does not exist, is empty, or has only files that an earlier run wrote.
/// The files are first written into a temporary folder beside it, which the destructor removes.
class VectorsFolder {
 public:
  /// Errors: EnvironmentError, which names the folder, if it is no folder, has other files, or cannot be
  /// written.
  explicit VectorsFolder(const std::string& asked);
  ~VectorsFolder();
  VectorsFolder(const VectorsFolder&) = delete;
  VectorsFolder& operator=(const VectorsFolder&) = delete;

  /// Puts the files in place, the manifest last. A new folder appears whole. In an existing one the manifest
  /// is removed first and put back last, so that it always describes whole vectors; files of the earlier run
  /// that are no longer listed are removed.
  /// Errors: EnvironmentError.
  void commit(std::span<const vectors::File> files);

 private:
  std::string asked_;
  std::filesystem::path folder_, stage_;
  std::set<std::string> before_;
  int lock_ = -1;  ///< the lock on the temporary folder
};

}  // namespace mmverify::cli
