#include "subjects/shaders/device/manifest.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace mmverify::shaders {

std::string to_text(const Manifest& manifest) {
  std::ostringstream out;
  out << "device " << manifest.device << '\n';
  for (const Module& m : manifest.modules)
    out << "module " << m.entry_point << ' ' << m.group_size << ' ' << m.function << ' ' << m.file << '\n';
  return out.str();
}

Manifest read_manifest(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file + ": no such file");
  Manifest manifest;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    ++number;
    if (kind == "device" && words >> manifest.device) continue;
    Module m;
    if (kind == "module" && words >> m.entry_point >> m.group_size >> m.function && m.group_size != 0 &&
        std::getline(words >> std::ws, m.file)) {
      manifest.modules.push_back(m);
      continue;
    }
    throw std::runtime_error(file + ":" + std::to_string(number) + ": no line of a manifest");
  }
  if (manifest.modules.empty()) throw std::runtime_error(file + ": it names no module");
  return manifest;
}

}  // namespace mmverify::shaders
