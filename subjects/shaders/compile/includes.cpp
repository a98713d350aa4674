#include "subjects/shaders/compile/includes.hpp"

#include <filesystem>

#include "subjects/program/own_folder.hpp"

namespace mmverify::shaders {

std::string include_root() {
  std::error_code error;
  const auto installed = program::own_folder() / "../share/mmverify";
  if (std::filesystem::exists(installed / "shaders", error)) return installed.lexically_normal().string();
  return MMVERIFY_SHADER_INCLUDES;
}

}  // namespace mmverify::shaders
