#include "subjects/shaders/compile/includes.hpp"

#include <filesystem>

namespace mmverify::shaders {

std::string program_folder() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path().string();
}

std::string include_root() {
  std::error_code error;
  const auto installed = std::filesystem::path(program_folder()) / "../share/mmverify";
  if (std::filesystem::exists(installed / "shaders", error)) return installed.lexically_normal().string();
  return MMVERIFY_SHADER_INCLUDES;
}

}  // namespace mmverify::shaders
