#include "proofs/engine/shape.hpp"

#include <map>
#include <mutex>
#include <regex>

namespace mmverify::proofs {

Groups groups_of(const std::string& text, const char* regex) {
  if (text.size() > longest) return std::nullopt;
  static std::mutex mutex;
  static std::map<std::string, std::regex> known;  // making one costs more than using it
  const std::regex* shape;
  {
    const std::lock_guard lock(mutex);
    auto found = known.find(regex);
    if (found == known.end()) found = known.emplace(regex, regex).first;
    shape = &found->second;
  }
  std::smatch m;
  if (!std::regex_match(text, m, *shape)) return std::nullopt;
  std::vector<std::string> parts;
  for (const auto& part : m) parts.push_back(part.str());
  return parts;
}

}  // namespace mmverify::proofs
