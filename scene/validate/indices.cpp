#include "scene/validate/indices.hpp"

#include <cstring>

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

std::optional<impl::micromap::Encoding> encoding_of(std::uint64_t component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return impl::micromap::Encoding::u8;
    case TINYGLTF_COMPONENT_TYPE_SHORT: return impl::micromap::Encoding::i16;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return impl::micromap::Encoding::u16;
    case TINYGLTF_COMPONENT_TYPE_INT: return impl::micromap::Encoding::i32;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return impl::micromap::Encoding::u32;
    default: return {};
  }
}

class IndexReader {
 public:
  IndexReader(const Document& document, const Buffers& buffers, std::size_t index, const std::string& pointer,
              Report& report)
      : document_(document),
        buffers_(buffers),
        accessor_(document.json["accessors"][index]),
        at_("/accessors/" + std::to_string(index)),
        pointer_(pointer),
        report_(report) {}

  std::optional<MicromapIndices> indices() {
    const auto number = [&](const char* key) { return accessor_.value(key, std::uint64_t{0}); };
    if (accessor_["type"] != "SCALAR")
      report_.add("indices.type", at_ + "/type", found(accessor_["type"]) + " where SCALAR is due");
    if (report_.newest() && accessor_.value("normalized", false))
      report_.add("indices.normalized", at_ + "/normalized", "true");
    const auto encoding = encoding_of(number("componentType"));
    if (!encoding)
      report_.add("indices.component", at_ + "/componentType",
                  std::to_string(number("componentType")) + " is no integer's, or a signed byte's");
    if (!encoding || accessor_["type"] != "SCALAR") return {};
    MicromapIndices read;
    read.encoding = *encoding;
    read.count = number("count");
    const std::uint64_t size = impl::micromap::width(*encoding) / 8;
    if (accessor_.contains("bufferView")) {
      const auto view = accessor_["bufferView"].get<std::size_t>();
      const auto stride = stride_of(view, size);
      if (!stride) return {};
      const std::uint64_t length = read.count == 0 ? 0 : (read.count - 1) * *stride + size;
      const auto bytes = run(view, number("byteOffset"), length, "indices.inside", pointer_);
      if (!bytes) return {};
      read.bytes = *bytes;
      if (*stride != size) {
        read.own.resize(static_cast<std::size_t>(read.count * size));
        for (std::uint64_t k = 0; k < read.count; ++k)
          std::memcpy(read.own.data() + k * size, bytes->data() + k * *stride,
                      static_cast<std::size_t>(size));
        read.bytes = read.own;
      }
      read.address =
          number("byteOffset") + document_.json["bufferViews"][view].value("byteOffset", std::uint64_t{0});
    } else {
      // An accessor without a view is zeros that cost the file nothing.
      if (read.count > std::uint64_t{1} << 22) {
        report_.add("limits.indices", at_ + "/count",
                    std::to_string(read.count) + " elements that no bufferView holds are not judged");
        return {};
      }
      read.own.assign(static_cast<std::size_t>(read.count * size), 0);
      read.bytes = read.own;
    }
    if (accessor_.contains("sparse") && !fill_in(accessor_["sparse"], static_cast<std::size_t>(size), read))
      return {};
    return read;
  }

 private:
  /// The bytes from one index to the next; none, and a finding, if they are 0.  The older drafts take the
  /// view's byteStride for the APIs' indexStride.  The newest draft has no stride, and plain_view() reports
  /// one.  As for every view that is read, the stride is a multiple of 4, and 252 at most.
  std::optional<std::uint64_t> stride_of(std::size_t view, std::uint64_t size) {
    if (report_.newest()) return size;
    const std::uint64_t stride = document_.json["bufferViews"][view].value("byteStride", size);
    if (stride != 0) return stride;
    report_.add("index.stride", pointer_, "the stride is 0");
    return {};
  }

  /// Bytes of a view, in place.
  std::optional<std::span<const unsigned char>> run(std::size_t view, std::uint64_t offset,
                                                    std::uint64_t bytes, const char* rule,
                                                    const std::string& pointer) {
    const auto all = plain_view(document_, buffers_, view, pointer, report_);
    if (!all) return {};
    // offset and bytes are both below 2^34.
    if (offset + bytes > all->size()) {
      report_.add(rule, pointer,
                  "bytes " + std::to_string(offset) + ".." + std::to_string(offset + bytes) + " of " +
                      place("bufferView", view) + ", which has " + std::to_string(all->size()));
      return {};
    }
    return all->subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(bytes));
  }

  /// Writes the elements that the accessor overrides.
  bool fill_in(const Json& sparse, std::size_t size, MicromapIndices& read) {
    const std::string at = at_ + "/sparse";
    const auto part = [&](const char* name, std::uint64_t width) {
      const Json& json = sparse[name];
      return run(json["bufferView"].get<std::size_t>(), json.value("byteOffset", std::uint64_t{0}),
                 sparse["count"].get<std::uint64_t>() * width, "indices.sparse", at + "/" + name);
    };
    const auto type = encoding_of(sparse["indices"]["componentType"].get<std::uint64_t>());
    if (!type || impl::micromap::is_signed(*type)) {
      report_.add("indices.sparse", at + "/indices/componentType",
                  found(sparse["indices"]["componentType"]) + " is none of 5121, 5123, 5125");
      return false;
    }
    const std::size_t width = impl::micromap::width(*type) / 8;
    const auto where = part("indices", width), what = part("values", size);
    if (!where || !what) return false;
    if (read.own.empty()) read.own.assign(read.bytes.begin(), read.bytes.end());
    std::uint64_t least = 0;
    for (std::size_t k = 0; k < where->size() / width; ++k) {
      std::uint32_t element = 0;
      std::memcpy(&element, where->data() + k * width, width);
      if (element < least || element >= read.count) {
        report_.add("indices.sparse", at + "/indices",
                    "index " + std::to_string(k) + " is " + std::to_string(element) + ", not from " +
                        std::to_string(least) + " up and below " + std::to_string(read.count));
        return false;
      }
      least = std::uint64_t{element} + 1;
      std::memcpy(read.own.data() + element * size, what->data() + k * size, size);
    }
    read.bytes = read.own;
    return true;
  }

  const Document& document_;
  const Buffers& buffers_;
  const Json& accessor_;
  std::string at_, pointer_;
  Report& report_;
};

}  // namespace

std::optional<MicromapIndices> read_micromap_indices(const Document& document, const Buffers& buffers,
                                                     std::size_t index, const std::string& pointer,
                                                     Report& report) {
  return IndexReader(document, buffers, index, pointer, report).indices();
}

}  // namespace mmverify::scene
