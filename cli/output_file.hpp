// Files that are whole or not there.
#pragma once

#include <sys/stat.h>

#include <optional>
#include <string>

namespace mmverify::cli {

/// A file that appears under its name only when commit() has written all of it. Opened at once, so that a place that
/// cannot be written is known before hours of work; EnvironmentError names the file.
/// A link stays, and what it names is written; a file that is replaced leaves its mode and owner to the new one.  Until then
/// the file has no name, or, where the file system knows no such files, one that nobody can guess; what a killed run left
/// under such a name, the next one of the same output removes.
class OutputFile {
 public:
  explicit OutputFile(const std::string& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Removes what an earlier run wrote, which must not be taken for this one's where this one fails.
  void remove_old() const;

  /// Writes the text, syncs it and moves it into place.
  void commit(const std::string& text);

 private:
  void open_beside();
  void take_mode() const;
  void name_it();

  std::string path_;    ///< as it was given, for messages
  std::string target_;  ///< behind links; empty: a pipe, a device or one of our own streams, written as it is
  std::string temporary_;           ///< the name until commit(); empty: it has none
  std::optional<struct stat> old_;  ///< the file that is replaced
  int descriptor_ = -1;
};

/// A name beside the target, under which something may be kept until it is whole.
std::string name_until_whole(const std::string& target);

/// Removes what killed runs left under such names, and nothing that a process has locked with flock().
void remove_left_over(const std::string& target);

/// Whether two paths name one file, there or not.  A path that cannot be followed names no other's file.
bool same_file(const std::string& a, const std::string& b);

}  // namespace mmverify::cli
