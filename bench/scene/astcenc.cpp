#include "bench/scene/astcenc.hpp"

#include <filesystem>
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

namespace fs = std::filesystem;
using impl::attribute::Meaning;

constexpr std::uint64_t header_bytes = 16, block_bytes = 16;

class Astcenc {
 public:
  explicit Astcenc(const AstcencOptions& options) : options_(options) {
    for (const char* const name :
         {"astcenc", "astcenc-avx2", "astcenc-sse4.1", "astcenc-sse2", "astcenc-neon"}) {
      try {
        const ProgramEnd end = run_program({name, "-version"}, {}, options_.stop);
        // A program for another instruction set ends by a signal.
        if (!end.succeeded || !end.out.starts_with("astcenc ")) continue;
        program_ = name;
        version_ = end.out.substr(0, end.out.find('\n'));
        return;
      } catch (const NoProgram&) {
        continue;
      }
    }
    throw NoProgram("--astc needs astcenc, which is not here: install the Debian package astcenc");
  }

  std::string name() const { return version_ + ", " + options_.quality; }

  void compress(const scene::TexturePixels& pixels, std::span<const scene::BlockSize> sizes,
                const std::function<void(const scene::DecodedTexture&)>& made) const {
    const program::Folder folder("textures");
    const std::string original = folder.file("original.png"), blocks = folder.file("blocks.astc"),
                      decoded = folder.file("decoded.png");
    write_file(original, scene::png(pixels.width, pixels.height, pixels.rgb));
    const bool srgb = pixels.meaning == Meaning::srgb;
    for (const scene::BlockSize& block : sizes) {
      if (options_.progress)
        options_.progress("ASTC, " + std::to_string(pixels.width) + " x " + std::to_string(pixels.height) +
                          " texels in blocks of " + block.name());
      std::vector<std::string> compress{srgb ? "-cs" : "-cl", original,         blocks,
                                        block.name(),         options_.quality, "-silent"};
      std::vector<std::string> decompress{srgb ? "-ds" : "-dl", blocks, decoded, "-silent"};
      if (pixels.meaning == Meaning::normal) {
        compress.push_back("-normal");
        // x comes from the blocks' red, y from their alpha, z from both.
        decompress.insert(decompress.end(), {"-dsw", "raz1"});
      }
      const std::uint64_t bytes = block_bytes * block.blocks_of(pixels.width, pixels.height);
      run(std::move(compress));
      expect_size(blocks, header_bytes + bytes, program_);
      run(std::move(decompress));
      made({block, bytes, rgb_of_png(decoded, pixels, "astcenc")});
      std::error_code ignored;
      fs::remove(blocks, ignored);
      fs::remove(decoded, ignored);
    }
  }

 private:
  void run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), program_);
    if (options_.threads != 0) arguments.insert(arguments.end(), {"-j", std::to_string(options_.threads)});
    const ProgramEnd end = run_program(arguments, {}, options_.stop);
    if (!end.succeeded)
      throw std::runtime_error(program_ + " " + arguments[1] + " failed, " + end.how + ": " +
                               program::one_line(end.errors.empty() ? end.out : end.errors));
  }

  AstcencOptions options_;
  std::string program_, version_;
};

}  // namespace

scene::TextureCoder astc_coder(const AstcencOptions& options) {
  const Astcenc astcenc(options);
  return {astcenc.name(),
          {std::begin(astc_blocks), std::end(astc_blocks)},
          {std::begin(reduced_astc_blocks), std::end(reduced_astc_blocks)},
          [astcenc](const auto& pixels, const auto& sizes, const auto& made) {
            astcenc.compress(pixels, sizes, made);
          }};
}

}  // namespace mmverify::bench
