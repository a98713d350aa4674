#include "subjects/program/own_folder.hpp"

#include <stdexcept>

namespace mmverify::program {

std::filesystem::path own_folder() {
  std::error_code error;
  const auto file = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error)
    throw std::runtime_error("/proc/self/exe, by which mmverify finds its own files, cannot be read: " +
                             error.message() + "; mount /proc");
  return file.parent_path();
}

}  // namespace mmverify::program
