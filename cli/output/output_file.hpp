// Output files that appear whole or not at all.
#pragma once

#include <sys/stat.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mmverify::cli {

/// A file that appears under its name only when commit() has written it. It is opened at once, so that a
/// place that cannot be written is found before hours of work; EnvironmentError names the file.
/// A symbolic link stays, and its target is written; a replaced file passes on its mode and owner. Until
/// commit() the file has no name, or, if the file system needs one, a name that nobody can guess. If a killed
/// run leaves such a name behind, the next run with the same output removes it.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Removes the file of an earlier run, which must not be mistaken for this run's if this run fails.
  void remove_old() const;

  /// Writes the text, syncs it and moves it into place.
  void commit(const std::string& text);

 private:
  void open_beside();
  void take_mode() const;
  void name_it();

  std::string path_;       ///< as given, for messages
  std::string target_;     ///< behind links; empty for a pipe, device or stream, which is written directly
  std::string temporary_;  ///< its name until commit(); empty if it has none
  std::optional<struct stat> old_;  ///< the file to replace
  int descriptor_ = -1;
};

/// A random name beside the target, for a file that is not yet whole.
std::string name_until_whole(const std::string& target);

/// Removes the files and folders that killed runs left under such names, except for those that a process has
/// locked with flock().
void remove_left_over(const std::string& target);

/// An argument, as messages name it, and its path: empty where it is not given, "-" for a standard stream.
using NamedPath = std::pair<const char*, std::string>;

/// UsageError if two arguments name one file, existing or not. A path that cannot be followed equals no other.
void refuse_same_file(const std::vector<NamedPath>& arguments);

/// EnvironmentError if the folder of an option is given and does not exist.
void refuse_no_folder(const char* option, const std::string& folder);

/// Makes the folder of an option, if it is given and does not exist. EnvironmentError if none can be made.
void need_folder(const char* option, const std::string& folder);

}  // namespace mmverify::cli
