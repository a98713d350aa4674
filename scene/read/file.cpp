#include "scene/read/file.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <fstream>

#include "scene/read/bad_scene.hpp"
#include "scene/read/word.hpp"

namespace mmverify::scene {
namespace {

namespace fs = std::filesystem;

int hex(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const int lower = std::tolower(static_cast<unsigned char>(c));
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

std::string percent_decoded(const std::string& uri) {
  std::string text;
  for (std::size_t k = 0; k < uri.size(); ++k) {
    if (uri[k] == '%' && k + 2 < uri.size() && hex(uri[k + 1]) >= 0 && hex(uri[k + 2]) >= 0) {
      text += static_cast<char>(16 * hex(uri[k + 1]) + hex(uri[k + 2]));
      k += 2;
    } else {
      text += uri[k];
    }
  }
  return text;
}

}  // namespace

std::uintmax_t check_file(const fs::path& path, const std::string& file, const std::string& place) {
  const std::string named = path == fs::path(file) ? "" : " '" + shown(path.filename().string()) + "'";
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::none)
    throw BadScene(file, place, "cannot be read" + named + ": " + error.message());
  if (!fs::exists(status))
    throw BadScene(file, place,
                   "there is no file" + named + (named.empty() ? "" : " beside it; is the folder complete?"));
  if (fs::is_directory(status)) throw BadScene(file, place, "a folder, where a file is due" + named);
  if (!fs::is_regular_file(status)) throw BadScene(file, place, "no regular file" + named);
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw BadScene(file, place, "cannot be read" + named + ": " + error.message());
  if (size == 0) throw BadScene(file, place, "an empty file" + named + "; truncated?");
  if (size > largest_file)
    throw BadScene(file, place, std::to_string(size) + " bytes" + named + "; at most 2^31 - 1 are read");
  return size;
}

Bytes read_file(const fs::path& path, const std::string& file, const std::string& place) {
  Bytes bytes(check_file(path, file, place));
  const auto size = static_cast<std::streamsize>(bytes.size());
  std::ifstream in(path, std::ios::binary);
  in.read(reinterpret_cast<char*>(bytes.data()), size);
  if (!in || in.gcount() != size)
    throw BadScene(file, place, "cannot be read: '" + shown(path.filename().string()) + "'; permissions?");
  return bytes;
}

Container split(std::span<const unsigned char> bytes, const std::string& file) {
  if (bytes.size() < 4 || std::memcmp(bytes.data(), "glTF", 4) != 0)
    return {std::string(bytes.begin(), bytes.end()), {}};
  constexpr std::size_t header = 12, chunk_header = 8;
  constexpr std::uint32_t json = 0x4E4F534A, binary = 0x004E4942;
  const auto bad = [&](const std::string& what) { throw BadScene(file, "GLB", what); };
  if (bytes.size() < header) bad("a header of 12 bytes is due, there are " + std::to_string(bytes.size()));
  if (word_at(bytes, 4) != 2)
    bad("container version " + std::to_string(word_at(bytes, 4)) + "; only 2 is read");
  if (word_at(bytes, 8) != bytes.size())
    bad("its header says " + std::to_string(word_at(bytes, 8)) + " bytes, the file has " +
        std::to_string(bytes.size()) + "; truncated file?");
  Container parts;
  std::size_t at = header;
  for (int chunk = 0; at < bytes.size(); ++chunk) {
    const std::string name = "chunk " + std::to_string(chunk);
    if (bytes.size() - at < chunk_header) bad(name + ": its header is cut off; truncated file?");
    const std::size_t length = word_at(bytes, at);
    const std::uint32_t type = word_at(bytes, at + 4);
    at += chunk_header;
    if (length > bytes.size() - at)
      bad(name + ": bytes " + std::to_string(at) + ".." + std::to_string(at + length) + " of a " +
          std::to_string(bytes.size()) + "-byte file; truncated file?");
    if ((type == json) != (chunk == 0)) bad(name + ": the JSON chunk must be the first, and alone");
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = begin + static_cast<std::ptrdiff_t>(length);
    if (chunk == 0) parts.json.assign(begin, end);
    // Chunks of other types, and after the second, belong to other programs and are ignored.
    if (chunk == 1 && type == binary) parts.binary.emplace(begin, end);
    // The padding of the last chunk may be missing.
    at += std::min(bytes.size() - at, (length + 3) / 4 * 4);
  }
  if (at == header) bad("no JSON chunk; truncated file?");
  return parts;
}

bool stays_within(const std::string& name) {
  if (name.empty() || name.find('\0') != std::string::npos) return false;
  for (std::size_t from = 0; from <= name.size();) {
    const std::size_t to = std::min(name.find('/', from), name.size());
    const std::string part = name.substr(from, to - from);
    if (part.empty() || part == "." || part == "..") return false;
    from = to + 1;
  }
  return true;
}

fs::path in_folder_of(const std::string& file, const std::string& name, const std::string& place) {
  const fs::path folder = fs::path(file).parent_path(), path = folder / name;
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  if (error) return path;  // its reader reports the reason
  const auto holds_it = [&](const fs::path& home) {
    return !home.empty() &&
           std::mismatch(home.begin(), home.end(), real.begin(), real.end()).first == home.end();
  };
  // The file itself may be a link into the folder of its companions.
  if (!holds_it(fs::canonical(folder.empty() ? "." : folder, error)) &&
      !holds_it(fs::canonical(file, error).parent_path()))
    throw BadScene(file, place,
                   "'" + shown(name) + "' is a link out of the file's folder; put the file itself there");
  return path;
}

fs::path beside(const std::string& file, const std::string& uri, const std::string& place) {
  const std::size_t colon = uri.find(':');
  if (colon != std::string::npos && colon < uri.find_first_of("/?#"))
    throw BadScene(file, place,
                   "URI '" + shown(uri) + "': only files beside it and base64 data URIs are read");
  const std::string name = fs::path(percent_decoded(uri)).lexically_normal().string();
  if (!stays_within(name))
    throw BadScene(
        file, place,
        "URI '" + shown(uri) + "' is no relative path in the file's folder; put the file beside it or below");
  return in_folder_of(file, name, place);
}

}  // namespace mmverify::scene
