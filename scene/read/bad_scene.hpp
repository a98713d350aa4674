// A scene file that cannot be read.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace mmverify::scene {

/// A scene file that is missing, malformed or unsupported: not the program's fault, exit code 4 of the
/// command line.
///   what() is "FILE: PLACE: what was found; what would do"
/// It is one line, whatever names the file has: control characters are shown as '?', a name or number of more
/// than 200 bytes is cut.
class BadScene : public std::runtime_error {
 public:
  BadScene(std::string_view file, std::string_view place, std::string_view what);
};

/// A glTF that asks for a version that is not read here.
class UnreadVersion : public BadScene {
 public:
  using BadScene::BadScene;
};

/// Data of an extension that this program, or this build of it, does not read.  The file may be sound.
class UnreadExtension : public BadScene {
 public:
  using BadScene::BadScene;
};

/// Compressed data that its decoder refuses.
class DamagedData : public BadScene {
 public:
  using BadScene::BadScene;
};

/// A name from a file as a message may show it.
std::string shown(std::string_view name);

}  // namespace mmverify::scene
