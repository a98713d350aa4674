#include "scene/read/openexr.hpp"

#ifdef MMVERIFY_HAS_OPENEXR
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#endif

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scene/read/bad_scene.hpp"
#include "scene/read/image.hpp"
#include "scene/read/picture_kind.hpp"
#include "scene/read/word.hpp"

namespace mmverify::scene {

#ifdef MMVERIFY_HAS_OPENEXR

namespace {

class ExrStream : public Imf::IStream {
 public:
  explicit ExrStream(std::span<const unsigned char> bytes) : IStream("bytes"), bytes_(bytes) {}

  bool read(char to[], int count) override {
    if (count < 0 || static_cast<std::size_t>(count) > bytes_.size() - at_)
      throw std::runtime_error("it ends early");
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), count, to);
    at_ += static_cast<std::size_t>(count);
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t to) override {
    at_ = static_cast<std::size_t>(std::min<std::uint64_t>(to, bytes_.size()));
  }

 private:
  std::span<const unsigned char> bytes_;
  std::size_t at_ = 0;
};

/// Why a header is that of a picture that is not read; empty if it is read.
std::string why_unread_exr(const Imf::Header& header) {
  if (header.dataWindow() != header.displayWindow())
    return "an OpenEXR whose data window is not its display window";
  const Imf::Channel* const alpha = header.channels().findChannel("A");
  if (alpha != nullptr && (alpha->xSampling != 1 || alpha->ySampling != 1))
    return "an OpenEXR with an alpha of fewer texels";
  return "";
}

std::vector<float> alpha_of(Imf::InputFile& exr, std::uint32_t width, std::uint32_t height) {
  const auto& window = exr.header().dataWindow();
  std::vector<float> alpha(std::size_t{width} * height, 1);
  if (exr.header().channels().findChannel("A") == nullptr) return alpha;
  // The library counts from the window's least corner, which may be any.
  const std::ptrdiff_t first = std::ptrdiff_t{window.min.x} + std::ptrdiff_t{window.min.y} * width;
  Imf::FrameBuffer to;
  to.insert("A", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(alpha.data() - first), sizeof(float),
                            sizeof(float) * width));
  exr.setFrameBuffer(to);
  exr.readPixels(window.min.y, window.max.y);
  return alpha;
}

}  // namespace

void decode_openexr_alpha(std::span<const unsigned char> bytes, Image& image, const std::string& file,
                          const std::string& place) {
  constexpr std::size_t version_at = 4;
  constexpr std::uint32_t deep = 0x800, several_parts = 0x1000;
  if (bytes.size() >= version_at + 4 && (word_at(bytes, version_at) & (deep | several_parts)) != 0)
    throw UnreadExtension(file, place, "an OpenEXR of several parts, or of deep data, is not read here");
  try {
    ExrStream stream(bytes);
    Imf::InputFile exr(stream, 0);
    const auto& window = exr.header().dataWindow();
    check_sides(static_cast<std::uint64_t>(std::int64_t{window.max.x} - window.min.x + 1),
                static_cast<std::uint64_t>(std::int64_t{window.max.y} - window.min.y + 1), "an OpenEXR", file,
                place);
    if (const std::string why = why_unread_exr(exr.header()); !why.empty())
      throw UnreadExtension(file, place, why + " is not read here");
    image.width = static_cast<std::uint32_t>(window.max.x - window.min.x + 1);
    image.height = static_cast<std::uint32_t>(window.max.y - window.min.y + 1);
    std::vector<float> alpha = alpha_of(exr, image.width, image.height);
    const auto bad = std::find_if(alpha.begin(), alpha.end(), [](float a) { return !std::isfinite(a); });
    if (bad != alpha.end())
      throw BadScene(file, place,
                     "the alpha of texel " + std::to_string(bad - alpha.begin()) + " is not finite");
    image.alpha = std::move(alpha);
  } catch (const BadScene&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& fault) {
    throw BadScene(file, place,
                   "an OpenEXR that cannot be decoded (" + shown(fault.what()) + "); truncated file?");
  }
}

#else

void decode_openexr_alpha(std::span<const unsigned char> bytes, Image&, const std::string& file,
                          const std::string& place) {
  throw UnreadExtension(file, place,
                        why_unread(bytes, PictureUse::alpha).value_or("OpenEXR is not read here"));
}

#endif

}  // namespace mmverify::scene
