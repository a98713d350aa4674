#include "scene/read/images.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <span>
#include <thread>
#include <utility>

#ifndef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

#include "scene/read/bad_scene.hpp"
#include "scene/read/extensions.hpp"
#include "scene/read/image.hpp"
#include "scene/read/picture_kind.hpp"
#include "scene/read/resource.hpp"

namespace mmverify::scene {
namespace {

/// Bytes of images that are held at once.
constexpr std::size_t most_bytes = std::size_t{1} << 26;

/// An image that is not decoded yet.
struct Encoded {
  std::size_t number = 0;
  std::string at;
  Bytes own;                             ///< of a file or a URI; else empty
  std::span<const unsigned char> bytes;  ///< of a bufferView, or of `own`
};

Encoded encoded(const Document& document, const Buffers& buffers, std::size_t k, const std::string& name) {
  const nlohmann::json& given = member(document.json, "images")[k];
  Encoded image{k, place("image", k, name), {}, {}};
  check_extensions(document, given, image.at);
  if (given.contains("bufferView")) {
    image.bytes = buffers.view(given["bufferView"].get<std::size_t>());
  } else {
    image.own = read_resource(document, given["uri"].get<std::string>(), image.at);
    image.bytes = image.own;
  }
  return image;
}

/// Calls function(0) to function(count - 1), at most four at once: each may hold a large picture.
template <class Function>
void for_each_of(std::size_t count, const Function& function) {
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  for (std::size_t k = 0; k < count; ++k) function(k);  // harnesses link no threads
#else
  using Range = oneapi::tbb::blocked_range<std::size_t>;
  oneapi::tbb::task_arena arena(static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 4u)));
  arena.execute([&] {
    oneapi::tbb::parallel_for(Range(0, count), [&](const Range& range) {
      for (std::size_t k = range.begin(); k < range.end(); ++k) function(k);
    });
  });
#endif
}

/// Decodes PNG and JPEG at any time, other pictures one after another: not all their libraries allow threads.
void decode_one(const Encoded& from, Image& image, const std::string& file) {
  static std::mutex one_by_one;
  const PictureKind kind = picture_kind(from.bytes);
  std::unique_lock hold(one_by_one, std::defer_lock);
  if (kind != PictureKind::png && kind != PictureKind::jpeg) hold.lock();
  decode_alpha(from.bytes, image, file, from.at);
}

/// Images that wait to be decoded, with those that are.
class Decoder {
 public:
  Decoder(const Document& document, std::vector<Image>& images) : document_(document), images_(images) {}

  void add(Encoded image) {
    bytes_ += image.bytes.size();
    waiting_.push_back(std::move(image));
    if (bytes_ > most_bytes) decode();
  }

  /// Decodes all that wait; the first one's fault is thrown.
  void decode() {
    const std::vector<Encoded> now = std::exchange(waiting_, {});
    bytes_ = 0;
    std::vector<std::exception_ptr> faults(now.size());
    for_each_of(now.size(), [&](std::size_t k) {
      try {
        decode_one(now[k], images_[now[k].number], document_.file);
      } catch (...) {
        faults[k] = std::current_exception();
      }
    });
    for (const std::exception_ptr& fault : faults)
      if (fault) std::rethrow_exception(fault);
  }

 private:
  const Document& document_;
  std::vector<Image>& images_;
  std::vector<Encoded> waiting_;
  std::size_t bytes_ = 0;
};

}  // namespace

std::vector<Image> read_images(const Document& document, const Buffers& buffers,
                               const std::set<std::size_t>& to_decode) {
  const nlohmann::json& listed = member(document.json, "images");
  check_images_there(document);
  std::vector<Image> images(listed.size());
  Decoder decoder(document, images);
  try {
    for (std::size_t k = 0; k < listed.size(); ++k) {
      const nlohmann::json& given = listed[k];
      const std::string uri = given.value("uri", std::string());
      const bool embedded = uri.empty() || is_data_uri(uri);
      images[k].name = given.value("name", embedded ? std::string() : shown(uri));
      const std::string at = place("image", k, images[k].name);
      if (!given.contains("bufferView") && uri.empty())
        throw BadScene(document.file, at, "neither a URI nor a bufferView");
      if (to_decode.contains(k))
        decoder.add(encoded(document, buffers, k, images[k].name));
      else if (given.contains("bufferView"))
        buffers.view(given["bufferView"].get<std::size_t>());
      else if (embedded)
        read_resource(document, uri, at);
      else
        check_resource(document, uri, at);
    }
  } catch (...) {
    decoder.decode();  // an image before this one may be at fault, too
    throw;
  }
  decoder.decode();
  return images;
}

void read_image(const Document& document, const Buffers& buffers, std::size_t k, Image& image) {
  const Encoded given = encoded(document, buffers, k, image.name);
  decode_alpha(given.bytes, image, document.file, given.at);
}

}  // namespace mmverify::scene
