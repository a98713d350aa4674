// A library's file: what it holds, and whether it still does.
#pragma once

#include <sys/stat.h>

#include <string>

namespace mmverify::dock {

class LibraryFile {
 public:
  /// Reads the file.  One that cannot be read is as an empty one.
  explicit LibraryFile(std::string path);

  /// Its contents in a word: "(15960 bytes, crc 1a2b3c4d)".
  const std::string& fingerprint() const { return fingerprint_; }

  /// What it has become since it was read, in a sentence; empty where its contents are the same.  It is read again only
  /// where its size, its place or its times say that it was written.
  std::string change() const;

 private:
  std::string path_, fingerprint_;
  struct stat about_ {};
};

}  // namespace mmverify::dock
