#include "bench/scene/astcenc.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "bench/program/program.hpp"
#include "scene/read/image.hpp"
#include "scene/write/png.hpp"

namespace mmverify::bench {
namespace {

namespace fs = std::filesystem;
using impl::attribute::Meaning;

constexpr std::uint64_t header_bytes = 16, block_bytes = 16;

/// A folder that nobody else may enter, and that is gone with what is in it.
class PrivateFolder {
 public:
  PrivateFolder() {
    std::string name = (fs::temp_directory_path() / "mmverify-astc-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw std::runtime_error("astcenc: no temporary folder " + name + ": " + std::strerror(errno));
    path_ = name;
  }
  ~PrivateFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

void write_file(const std::string& path, const std::vector<unsigned char>& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written to the end; is the disk full?");
}

std::vector<unsigned char> read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<std::uint8_t> rgb_of_png(const std::string& path, const scene::TexturePixels& pixels) {
  scene::ColourImage image;
  scene::decode_colour(read_file(path), image, path, "what astcenc wrote");
  if (image.width != pixels.width || image.height != pixels.height)
    throw std::runtime_error("astcenc: a picture of " + std::to_string(image.width) + " x " +
                             std::to_string(image.height) + " came back, of another size than went in");
  std::vector<std::uint8_t> rgb;
  rgb.reserve(pixels.rgb.size());
  for (std::size_t k = 0; k < image.rgba.size(); k += 4)
    for (std::size_t c = 0; c < 3; ++c) rgb.push_back(image.rgba[k + c]);
  return rgb;
}

/// Its complaints in one line.
std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;) text.replace(at, 1, "; ");
  return text.empty() ? "it said nothing" : text;
}

class Astcenc {
 public:
  explicit Astcenc(const AstcencOptions& options) : options_(options) {
    for (const char* const name :
         {"astcenc", "astcenc-avx2", "astcenc-sse4.1", "astcenc-sse2", "astcenc-neon"}) {
      try {
        const ProgramEnd end = run_program({name, "-version"}, {}, options_.stop);
        // One for another instruction set ends by a signal.
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
    const PrivateFolder folder;
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
        // x from the blocks' red, y from their alpha, z of both.
        decompress.insert(decompress.end(), {"-dsw", "raz1"});
      }
      const std::uint64_t bytes = block_bytes * block.blocks_of(pixels.width, pixels.height);
      run(std::move(compress));
      expect_size(blocks, header_bytes + bytes);
      run(std::move(decompress));
      made({block, bytes, rgb_of_png(decoded, pixels)});
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
                               one_line(end.errors.empty() ? end.out : end.errors));
  }

  void expect_size(const std::string& file, std::uint64_t bytes) const {
    std::error_code none;
    const std::uintmax_t written = fs::file_size(file, none);
    if (!none && written == bytes) return;
    throw std::runtime_error(program_ + ": a file of " + std::to_string(bytes) + " bytes was due, and " +
                             (none ? "none is there" : "one of " + std::to_string(written) + " came"));
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
