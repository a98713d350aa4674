// Runs a fuzz harness on files instead of under libFuzzer: any compiler, no instrumentation.
//   PROGRAM FILE|DIRECTORY...      a directory stands for all files in and below it, in order of name
// Exit code 0 only if every argument gave at least one file and the harness came back from each; a finding
// aborts.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const fs::path& argument) {
  if (!fs::exists(argument)) throw std::runtime_error(argument.string() + ": no such file or directory");
  if (!fs::is_directory(argument)) return {argument};
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(argument))
    if (entry.is_regular_file()) files.push_back(entry.path());
  if (files.empty())
    throw std::runtime_error(argument.string() + ": no files in this directory; nothing to replay");
  std::sort(files.begin(), files.end());
  return files;
}

void replay(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) throw std::runtime_error(file.string() + ": cannot be read");
  const std::vector<std::uint8_t> input(bytes.begin(), bytes.end());
  // The name is printed before the run: a finding aborts, and this line then names the file.
  std::fprintf(stderr, "replaying %s (%zu bytes)\n", file.c_str(), input.size());
  LLVMFuzzerTestOneInput(input.data(), input.size());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 2) throw std::runtime_error("no input given; usage: replay FILE|DIRECTORY...");
    std::vector<fs::path> files;
    for (int a = 1; a < argc; ++a)
      for (auto& file : files_of(argv[a])) files.push_back(std::move(file));
    for (const fs::path& file : files) replay(file);
    std::printf("replayed %zu inputs\n", files.size());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "replay: %s\n", error.what());
    return 1;
  }
}
