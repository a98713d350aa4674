#include "scene/read/meshopt.hpp"

#ifdef MMVERIFY_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

#include "scene/read/bad_scene.hpp"

namespace mmverify::scene {
namespace {

using Json = nlohmann::json;

constexpr const char* meshopt_names[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};

std::size_t number_of_member(const Document& document, const Json& json, const char* key, bool required,
                             const std::string& at) {
  const auto found = json.find(key);
  if (found == json.end() && !required) return 0;
  if (found == json.end() || !found->is_number_unsigned() || found->get<std::uint64_t>() > largest_file)
    throw BadScene(document.file, at, std::string(key) + " is no whole number from 0 to 2^31 - 1");
  return found->get<std::size_t>();
}

std::string word_of(const Document& document, const Json& json, const char* key, const char* otherwise,
                    const std::string& at) {
  const auto found = json.find(key);
  if (found == json.end()) return otherwise;
  if (!found->is_string()) throw BadScene(document.file, at, std::string(key) + " is no string");
  return found->get<std::string>();
}

#ifdef MMVERIFY_HAS_MESHOPT

/// The version in the first byte of a code, below its kind.
constexpr unsigned char version_bits = 0x0f, newest_vertex_version = 0, newest_index_version = 1;

bool fits(const MeshoptView& view) {
  const std::size_t stride = view.stride;
  if (view.mode == "ATTRIBUTES") return stride >= 4 && stride <= 256 && stride % 4 == 0;
  const bool index = stride == 2 || stride == 4;
  if (view.mode == "TRIANGLES") return index && view.count % 3 == 0 && view.filter == "NONE";
  return view.mode == "INDICES" && index && view.filter == "NONE";
}

bool filter_fits(const MeshoptView& view) {
  if (view.filter == "OCTAHEDRAL") return view.stride == 4 || view.stride == 8;
  if (view.filter == "QUATERNION") return view.stride == 8;
  return view.filter == "NONE" || view.filter == "EXPONENTIAL";
}

int decode_by_mode(const MeshoptView& view, std::span<const unsigned char> from, Bytes& to) {
  if (view.mode == "TRIANGLES")
    return meshopt_decodeIndexBuffer(to.data(), view.count, view.stride, from.data(), from.size());
  if (view.mode == "INDICES")
    return meshopt_decodeIndexSequence(to.data(), view.count, view.stride, from.data(), from.size());
  return meshopt_decodeVertexBuffer(to.data(), view.count, view.stride, from.data(), from.size());
}

void unfilter(const MeshoptView& view, Bytes& bytes) {
  if (view.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(bytes.data(), view.count, view.stride);
  if (view.filter == "QUATERNION") meshopt_decodeFilterQuat(bytes.data(), view.count, view.stride);
  if (view.filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), view.count, view.stride);
}

#endif

}  // namespace

std::vector<MeshoptView> meshopt_views(const Document& document, const Json& view, const std::string& at) {
  std::vector<MeshoptView> all;
  for (const char* name : meshopt_names) {
    if (!member(view, "extensions").contains(name)) continue;
    const Json& json = extension(view, name);
    const std::string of = at + ": " + name;
    if (!json.is_object()) throw BadScene(document.file, of, "an object is due");
    MeshoptView found;
    found.extension = name;
    found.buffer = number_of_member(document, json, "buffer", true, of);
    found.offset = number_of_member(document, json, "byteOffset", false, of);
    found.length = number_of_member(document, json, "byteLength", true, of);
    found.stride = number_of_member(document, json, "byteStride", true, of);
    found.count = number_of_member(document, json, "count", true, of);
    found.mode = word_of(document, json, "mode", "", of);
    found.filter = word_of(document, json, "filter", "NONE", of);
    if (const std::size_t buffers = member(document.json, "buffers").size(); found.buffer >= buffers)
      throw BadScene(
          document.file, of,
          "buffer " + std::to_string(found.buffer) + ", of which there are " + std::to_string(buffers));
    all.push_back(std::move(found));
  }
  return all;
}

bool is_meshopt_fallback(const Json& buffer) {
  for (const char* name : meshopt_names) {
    const Json& json = extension(buffer, name);
    if (json.is_object() && member(json, "fallback") == true) return true;
  }
  return false;
}

bool has_meshopt() noexcept {
#ifdef MMVERIFY_HAS_MESHOPT
  return true;
#else
  return false;
#endif
}

#ifdef MMVERIFY_HAS_MESHOPT

Bytes decode_meshopt(const MeshoptView& view, std::span<const unsigned char> compressed,
                     const std::string& file, const std::string& at) {
  const std::string of = at + ": " + view.extension;
  if (view.filter == "COLOR") throw UnreadExtension(file, of, "the filter COLOR is not read here");
  if (!fits(view) || !filter_fits(view))
    throw BadScene(file, of,
                   "mode '" + shown(view.mode) + "', filter '" + shown(view.filter) + "', " +
                       std::to_string(view.count) + " elements of " + std::to_string(view.stride) +
                       " bytes do not go together");
  // An element's bit costs at least a 64th of one, so that no small file claims gigabytes.
  constexpr std::size_t best_ratio = 64, around = 512;
  if (view.count != 0 && (compressed.size() + around) * best_ratio / view.stride < view.count)
    throw DamagedData(file, of,
                      std::to_string(view.count) + " elements cannot be in " +
                          std::to_string(compressed.size()) + " bytes; truncated file?");
  const unsigned char version = compressed.empty() ? 0 : compressed[0] & version_bits;
  if (version > (view.mode == "ATTRIBUTES" ? newest_vertex_version : newest_index_version))
    throw UnreadExtension(file, of,
                          "version " + std::to_string(version) + " of the code of " + view.mode +
                              " is newer than the installed library reads");
  Bytes bytes(view.count * view.stride);
  if (view.count != 0 && decode_by_mode(view, compressed, bytes) != 0)
    throw DamagedData(file, of, "its " + view.mode + " cannot be decoded; damaged file?");
  unfilter(view, bytes);
  return bytes;
}

#else

Bytes decode_meshopt(const MeshoptView& view, std::span<const unsigned char>, const std::string& file,
                     const std::string& at) {
  throw UnreadExtension(
      file, at,
      "compressed with " + view.extension +
          ", and this program was built without meshoptimizer (Debian: libmeshoptimizer-dev)");
}

#endif

}  // namespace mmverify::scene
