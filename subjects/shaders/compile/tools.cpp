#include "subjects/shaders/compile/tools.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace mmverify::shaders {

namespace fs = std::filesystem;

std::optional<program::ProgramEnd> ended(const std::vector<std::string>& words,
                                         std::uint64_t bytes_of_memory) {
  using std::chrono_literals::operator""s;
  try {
    return program::run_program(words, {}, {}, {60s, bytes_of_memory, std::uint64_t{64} << 20});
  } catch (const program::NoProgram&) {
    return std::nullopt;
  }
}

std::string contents_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || fs::is_directory(file)) throw std::runtime_error(file + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_file(const std::string& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(file + ": cannot be written");
}

}  // namespace mmverify::shaders
