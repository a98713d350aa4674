#include "scene/read/accessor.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "scene/read/bad_scene.hpp"
#include "scene/read/extensions.hpp"

namespace mmverify::scene {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF's bytes are little-endian");

constexpr std::size_t most_elements = std::size_t{1} << 26;
// Zeros without a view cost the file nothing.
constexpr std::size_t most_without_view = std::size_t{1} << 22;

/// A run of elements that has been checked to lie in its view.
struct Elements {
  const unsigned char* first = nullptr;  ///< null: all zero
  std::size_t stride = 0, count = 0;
  int component_type = 0;
  std::size_t component_size = 0;
};

template <class T>
T load_as(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

class ElementReader {
 public:
  ElementReader(const Document& document, const Buffers& buffers, std::size_t index, const std::string& at,
                const Bytes* decoded)
      : document_(document),
        buffers_(buffers),
        accessor_(document.model.accessors[index]),
        decoded_(decoded),
        at_(at + ": " + place("accessor", index)) {
    check_extensions(document, document.json["accessors"][index], at_);
  }

  const tinygltf::Accessor& accessor() const { return accessor_; }

  [[noreturn]] void bad(const std::string& what) const { throw BadScene(document_.file, at_, what); }

  void check_shape(int components) const {
    if (tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor_.type)) != components)
      bad("elements of " + std::to_string(components) + " component(s) are due");
    if (accessor_.count > most_elements)
      bad(std::to_string(accessor_.count) + " elements; more than 2^26 are not read");
    if (!is_held() && accessor_.count > most_without_view)
      bad(std::to_string(accessor_.count) +
          " elements that no bufferView holds; more than 2^22 are not read");
    if (accessor_.count == 0) bad("no elements; at least one is due");
  }

  void check_unsigned(int type) const {
    if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
        type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
      bad("unsigned integers are due, not component type " + std::to_string(type));
  }

  Elements elements(int components) const {
    if (decoded_ != nullptr) return of_decoded(components);
    if (accessor_.bufferView < 0) return {nullptr, 0, accessor_.count, accessor_.componentType, 0};
    const auto view = static_cast<std::size_t>(accessor_.bufferView);
    return in_view(view, accessor_.byteOffset, document_.model.bufferViews[view].byteStride, accessor_.count,
                   accessor_.componentType, components);
  }

  /// The two halves of a sparse accessor.
  Elements sparse_indices() const {
    check_unsigned(accessor_.sparse.indices.componentType);
    return in_view(static_cast<std::size_t>(accessor_.sparse.indices.bufferView),
                   static_cast<std::size_t>(accessor_.sparse.indices.byteOffset), 0,
                   static_cast<std::size_t>(accessor_.sparse.count), accessor_.sparse.indices.componentType,
                   1);
  }
  Elements sparse_values(int components) const {
    return in_view(static_cast<std::size_t>(accessor_.sparse.values.bufferView),
                   static_cast<std::size_t>(accessor_.sparse.values.byteOffset), 0,
                   static_cast<std::size_t>(accessor_.sparse.count), accessor_.componentType, components);
  }

  /// Element k.  Domain: a type that check_unsigned() takes.
  std::uint32_t unsigned_at(const Elements& elements, std::size_t k) const {
    const unsigned char* bytes = elements.first + k * elements.stride;
    switch (elements.component_type) {
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return *bytes;
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return load_as<std::uint16_t>(bytes);
      default: return load_as<std::uint32_t>(bytes);
    }
  }

  /// Calls callback(k, index) for each element that a sparse accessor overrides.
  template <class Callback>
  void for_each_sparse(const Callback& callback) const {
    if (!accessor_.sparse.isSparse) return;
    const Elements indices = sparse_indices();
    for (std::size_t k = 0; k < indices.count; ++k) {
      const std::uint32_t where = unsigned_at(indices, k);
      if (where >= accessor_.count)
        bad("sparse index " + std::to_string(k) + " is " + std::to_string(where) + " of " +
            std::to_string(accessor_.count) + " elements");
      callback(k, where);
    }
  }

 private:
  bool is_held() const { return decoded_ != nullptr || accessor_.bufferView >= 0; }

  Elements of_decoded(int components) const {
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor_.componentType));
    const auto element = static_cast<std::size_t>(size * components);
    if (size <= 0 || decoded_->size() != accessor_.count * element)
      bad(std::to_string(decoded_->size()) + " decoded bytes for " + std::to_string(accessor_.count) +
          " elements");
    return {decoded_->data(), element, accessor_.count, accessor_.componentType,
            static_cast<std::size_t>(size)};
  }

  Elements in_view(std::size_t view, std::size_t offset, std::size_t stride, std::size_t count,
                   int component_type, int components) const {
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type));
    // 64-bit components are tinygltf's, not glTF's.
    if (size <= 0 || size > 4) bad("unknown component type " + std::to_string(component_type));
    const std::size_t element = static_cast<std::size_t>(size * components);
    const std::span<const unsigned char> bytes = buffers_.view(view);
    if (stride == 0) stride = element;
    if (stride < element)
      bad("byteStride " + std::to_string(stride) + " of " + place("bufferView", view) +
          " is less than an element's " + std::to_string(element) + " bytes");
    if (count == 0) return {nullptr, stride, 0, component_type, static_cast<std::size_t>(size)};
    // count < 2^31 and stride < 2^8: no overflow.
    const std::size_t end = offset + (count - 1) * stride + element;
    if (end > bytes.size())
      bad("bytes " + std::to_string(offset) + ".." + std::to_string(end) + " of " +
          place("bufferView", view) + ", which has " + std::to_string(bytes.size()) + "; truncated file?");
    return {bytes.data() + offset, stride, count, component_type, static_cast<std::size_t>(size)};
  }

  const Document& document_;
  const Buffers& buffers_;
  const tinygltf::Accessor& accessor_;
  const Bytes* decoded_;
  std::string at_;
};

template <class T>
float normalised(T value) {
  return std::max(static_cast<float>(value) / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
}

float component(int type, bool normal, const unsigned char* bytes) {
  const auto integer = [normal](auto value) {
    return normal ? normalised(value) : static_cast<float>(value);
  };
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return integer(load_as<std::int8_t>(bytes));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return integer(load_as<std::uint8_t>(bytes));
    case TINYGLTF_COMPONENT_TYPE_SHORT: return integer(load_as<std::int16_t>(bytes));
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return integer(load_as<std::uint16_t>(bytes));
    default: return load_as<float>(bytes);
  }
}

}  // namespace

std::vector<float> read_floats(const Document& document, const Buffers& buffers, std::size_t index,
                               int components, Integers integers, const std::string& at,
                               const Bytes* decoded) {
  const ElementReader reader(document, buffers, index, at, decoded);
  const tinygltf::Accessor& accessor = reader.accessor();
  reader.check_shape(components);
  const int type = accessor.componentType;
  const bool is_float = type == TINYGLTF_COMPONENT_TYPE_FLOAT;
  if (!is_float) {
    const bool is_unsigned =
        type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    const bool is_signed = type == TINYGLTF_COMPONENT_TYPE_BYTE || type == TINYGLTF_COMPONENT_TYPE_SHORT;
    const bool allowed = integers == Integers::any ? is_unsigned || is_signed
                                                   : integers == Integers::unsigned_normalised &&
                                                         is_unsigned && accessor.normalized;
    if (!allowed)
      reader.bad("component type " + std::to_string(type) + (accessor.normalized ? ", normalized," : "") +
                 " is not allowed for it");
  }
  const Elements elements = reader.elements(components);
  const auto width = static_cast<std::size_t>(components);
  std::vector<float> values(elements.count * width, 0.0f);
  const auto copy = [&](const Elements& from, std::size_t k, std::size_t to) {
    for (std::size_t c = 0; c < width; ++c)
      values[to * width + c] =
          component(type, accessor.normalized, from.first + k * from.stride + c * from.component_size);
  };
  if (elements.first != nullptr)
    for (std::size_t k = 0; k < elements.count; ++k) copy(elements, k, k);
  if (accessor.sparse.isSparse) {
    const Elements sparse = reader.sparse_values(components);
    reader.for_each_sparse([&](std::size_t k, std::size_t to) { copy(sparse, k, to); });
  }
  if (is_float)
    for (std::size_t k = 0; k < values.size(); ++k)
      if (!std::isfinite(values[k]))
        reader.bad("element " + std::to_string(k / width) + " is " + std::to_string(values[k]) +
                   ", not finite");
  return values;
}

std::vector<std::uint32_t> read_indices(const Document& document, const Buffers& buffers, std::size_t index,
                                        const std::string& at, const Bytes* decoded) {
  const ElementReader reader(document, buffers, index, at, decoded);
  reader.check_shape(1);
  reader.check_unsigned(reader.accessor().componentType);
  const Elements elements = reader.elements(1);
  std::vector<std::uint32_t> values(elements.count, 0);
  if (elements.first != nullptr)
    for (std::size_t k = 0; k < elements.count; ++k) values[k] = reader.unsigned_at(elements, k);
  if (reader.accessor().sparse.isSparse) {
    const Elements sparse = reader.sparse_values(1);
    reader.for_each_sparse(
        [&](std::size_t k, std::size_t to) { values[to] = reader.unsigned_at(sparse, k); });
  }
  const std::uint64_t restart =
      (std::uint64_t{1} << (8 * std::max<std::size_t>(elements.component_size, 1))) - 1;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (elements.first != nullptr && values[k] == restart)
      reader.bad("element " + std::to_string(k) + " is " + std::to_string(restart) + ", a primitive restart");
  return values;
}

}  // namespace mmverify::scene
