// Folders of temporary files: whose they are, and who removes them.
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "subjects/program/folder.hpp"
#include "tests/folder.hpp"

namespace {

using namespace mmverify;
using program::Folder;
namespace fs = std::filesystem;

TEST(Folder, OfAProcessThatWasKilledIsSwept) {
  const tests::Folder place;
  const std::string before = fs::temp_directory_path().string();
  ASSERT_EQ(setenv("TMPDIR", place.path().string().c_str(), 1), 0);
  fs::create_directory(place / "mmverify-files-killed");
  std::ofstream(place / "mmverify-files-killed/file") << "text";
  fs::create_directory(place / "somebody-else");
  {
    const Folder living("files");
    std::ofstream(living.file("file")) << "text";
    EXPECT_FALSE(fs::exists(place / "mmverify-files-killed"));
    EXPECT_TRUE(fs::exists(place / "somebody-else"));
    const Folder another("files");
    EXPECT_TRUE(fs::exists(living.file("file")));
    // A process that ends by a signal, and leaves its folder.
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      const Folder its("files");
      std::ofstream(its.file("file")) << "text";
      kill(getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    const auto folders = [&] {
      return std::distance(fs::directory_iterator(place.path()), fs::directory_iterator());
    };
    EXPECT_EQ(folders(), 4);
    const Folder next("files");
    EXPECT_EQ(folders(), 4);
    EXPECT_TRUE(fs::exists(living.file("file")));
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(place.path()), fs::directory_iterator()), 1);
  setenv("TMPDIR", before.c_str(), 1);
}

TEST(Folder, ThatCannotBeMadeSaysWhere) {
  const std::string before = fs::temp_directory_path().string();
  const tests::Folder place;
  const std::string gone = (place / "gone").string();
  fs::create_directory(gone);
  ASSERT_EQ(setenv("TMPDIR", gone.c_str(), 1), 0);
  fs::remove(gone);
  EXPECT_THROW(Folder("files"), std::exception);
  setenv("TMPDIR", before.c_str(), 1);
}

// A file system of 16 KiB is mounted in a namespace of a child; where nobody may make one, the test skips.
TEST(Folder, OnAFullFileSystemSaysSo) {
  const tests::Folder place;
  const std::string path = place.path().string();
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  constexpr int no_namespace = 77;
  if (child == 0) {
    const auto written = [](const char* file, const std::string& text) {
      return !!(std::ofstream(file) << text).flush();
    };
    const std::string user = std::to_string(getuid()), group = std::to_string(getgid());
    if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0 || !written("/proc/self/setgroups", "deny") ||
        !written("/proc/self/uid_map", user + ' ' + user + " 1") ||
        !written("/proc/self/gid_map", group + ' ' + group + " 1") ||
        mount("none", path.c_str(), "tmpfs", 0, "size=16k") != 0)
      _exit(no_namespace);
    setenv("TMPDIR", path.c_str(), 1);
    try {
      const Folder full("files");
    } catch (const std::exception& error) {
      const bool left = fs::directory_iterator(place.path()) != fs::directory_iterator();
      _exit(!left && std::string(error.what())
                         .ends_with(": its file system is full; set TMPDIR to a folder with room")
                ? 0
                : 1);
    }
    _exit(2);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  if (WEXITSTATUS(status) == no_namespace) GTEST_SKIP() << "no file system can be mounted here";
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
