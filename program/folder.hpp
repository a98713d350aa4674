// A folder of temporary files for programs of others.
#pragma once

#include <string>

namespace mmverify::program {

/// A folder that nobody else may enter, removed with this and with all that is in it.  A process that is killed leaves
/// its folder behind: the next folder of its kind removes those of processes that have ended.  A folder is its process's
/// as long as that holds a lock on it.
class Folder {
 public:
  /// Named mmverify-KIND-, and six letters.
  /// Errors: std::runtime_error where it cannot be made, or no room is left for files in it.
  explicit Folder(const std::string& kind);
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const;
  /// Errors: std::runtime_error where the file system has less than 64 KiB left.
  void check_room() const;

 private:
  void remove() const;

  std::string path_;
  int lock_ = -1;
};

}  // namespace mmverify::program
