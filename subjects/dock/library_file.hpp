// A library's file: its fingerprint, and whether it still has that content.
#pragma once

#include <sys/stat.h>

#include <string>

namespace mmverify::dock {

class LibraryFile {
 public:
  /// Reads the file. One that cannot be read counts as empty.
  explicit LibraryFile(std::string path);

  /// The size and checksum of its contents: "(15960 bytes, crc 1a2b3c4d)".
  const std::string& fingerprint() const { return fingerprint_; }

  /// A sentence on how the file has changed since it was read; empty if its contents are the same. The file
  /// is read again only if its size, place or times show a write.
  std::string change() const;

 private:
  std::string path_, fingerprint_;
  struct stat about_ {};
};

}  // namespace mmverify::dock
