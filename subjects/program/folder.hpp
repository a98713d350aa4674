// A folder of temporary files for the programs that mmverify runs.
#pragma once

#include <string>

namespace mmverify::program {

/// A folder that no other user may enter. Its destructor removes it with all its files. A process holds a
/// lock on its folder; one that is killed leaves the folder behind, and the next folder of the same kind
/// removes it.
class Folder {
 public:
  /// The name is mmverify-KIND- and six letters.
  /// Errors: std::runtime_error if the folder cannot be made, or has no room for files.
  explicit Folder(const std::string& kind);
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const;
  /// Errors: std::runtime_error if the file system has less than 64 KiB left.
  void check_room() const;

 private:
  void remove() const;

  std::string path_;
  int lock_ = -1;
};

}  // namespace mmverify::program
