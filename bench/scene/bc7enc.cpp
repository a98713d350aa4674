#include "bench/scene/bc7enc.hpp"

#include <stdexcept>

#include "bench/scene/coder_files.hpp"
#include "scene/write/png.hpp"
#include "subjects/program/folder.hpp"
#include "subjects/program/program.hpp"

namespace mmverify::bench {
namespace {

using program::NoProgram;
using program::ProgramEnd;
using program::run_program;

/// The sizes in a DDS file of the extended form: 4 bytes of a name, 124 and 20 of headers; a block.
constexpr std::uint64_t header_bytes = 148, block_bytes = 16;

class Bc7enc {
 public:
  explicit Bc7enc(const Bc7encOptions& options) : options_(options) {
    for (const char* const name : {"bc7enc", "bc7enc-linux"}) {
      try {
        // Without arguments the program prints its usage, and its version at the end.
        const ProgramEnd end = run_program({name}, {}, options_.stop);
        const std::string said = end.out + end.errors;
        const std::size_t at = said.rfind("bc7enc v");
        if (at == std::string::npos) continue;
        program_ = name;
        version_ = said.substr(at, said.find_first_of(" \n", at + 8) - at);
        return;
      } catch (const NoProgram&) {
        continue;
      }
    }
    throw NoProgram(
        "--bc7 needs bc7enc, which is not here: npm install -g @gpu-tex-enc/bc has it, and Debian's libomp5 "
        "what it needs");
  }

  std::string name() const { return version_ + ", " + quality(); }

  void compress(const scene::TexturePixels& pixels, std::span<const scene::BlockSize> sizes,
                const std::function<void(const scene::DecodedTexture&)>& made) const {
    for (const scene::BlockSize& block : sizes) {
      if (options_.progress)
        options_.progress("BC7, " + std::to_string(pixels.width) + " x " + std::to_string(pixels.height) +
                          " texels");
      const program::Folder folder("textures");
      const std::string original = folder.file("original.png"), blocks = folder.file("blocks.dds"),
                        decoded = folder.file("decoded.png");
      write_file(original, scene::png(pixels.width, pixels.height, pixels.rgb));
      const std::uint64_t bytes = block_bytes * block.blocks_of(pixels.width, pixels.height);
      run({program_, "-q", quality(), original, blocks, decoded});
      expect_size(blocks, header_bytes + bytes, program_);
      made({block, bytes, rgb_of_png(decoded, pixels, "bc7enc")});
    }
  }

 private:
  std::string quality() const { return "-u" + std::to_string(options_.quality); }

  void run(std::vector<std::string> arguments) const {
    // The program has no option of threads; OpenMP has.
    if (options_.threads != 0)
      arguments.insert(arguments.begin(), {"env", "OMP_NUM_THREADS=" + std::to_string(options_.threads)});
    const ProgramEnd end = run_program(arguments, {}, options_.stop);
    if (!end.succeeded)
      throw std::runtime_error(program_ + " " + quality() + " failed, " + end.how + ": " +
                               program::one_line(end.errors.empty() ? end.out : end.errors));
  }

  Bc7encOptions options_;
  std::string program_, version_;
};

}  // namespace

scene::TextureCoder bc7_coder(const Bc7encOptions& options) {
  const Bc7enc bc7enc(options);
  return {bc7enc.name(),
          {bc7_block},
          {bc7_block},
          [bc7enc](const auto& pixels, const auto& sizes, const auto& made) {
            bc7enc.compress(pixels, sizes, made);
          },
          "bc7",
          "BC7"};
}

}  // namespace mmverify::bench
