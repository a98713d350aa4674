#include "impl/array/container.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <string>

namespace mmverify::impl::array {
namespace {

constexpr char name[] = {'M', 'M', 'A', 'R', 'R', 'A', 'Y', 'S'};
constexpr std::uint32_t encodings = 5;

std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
  std::uint32_t sum = 0x811C9DC5;
  for (const std::uint8_t b : bytes) sum = (sum ^ b) * 0x01000193;
  return sum;
}

std::size_t index_bytes(Encoding e) { return micromap::width(e) / 8; }

class Writer {
 public:
  void word(std::uint64_t value) {
    if (value > 0xffffffff) throw std::invalid_argument("array::written: a count beyond 32 bits");
    const std::uint32_t w = static_cast<std::uint32_t>(value);
    bytes(&w, sizeof w);
  }
  void bytes(const void* from, std::size_t count) {
    if (count == 0) return;
    out.resize(out.size() + count);
    std::memcpy(out.data() + out.size() - count, from, count);
  }
  Bytes out;
};

[[noreturn]] void bad(std::size_t at, const std::string& what) {
  throw std::invalid_argument("byte " + std::to_string(at) + ": " + what);
}

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> file) : file_(file) {}
  std::size_t at() const { return at_; }
  std::size_t left() const { return file_.size() - at_; }
  std::span<const std::uint8_t> take(std::uint64_t count, const char* what) {
    if (left() < count)
      bad(at_, std::string(what) + ": " + std::to_string(count) + " bytes are due, " +
                   std::to_string(left()) + " are left; cut short?");
    at_ += static_cast<std::size_t>(count);
    return file_.subspan(at_ - static_cast<std::size_t>(count), static_cast<std::size_t>(count));
  }
  std::uint32_t word(const char* what) {
    std::uint32_t value;
    std::memcpy(&value, take(sizeof value, what).data(), sizeof value);
    return value;
  }

 private:
  std::span<const std::uint8_t> file_;
  std::size_t at_ = 0;
};

}  // namespace

Bytes written(const Bundle& b, std::uint32_t version) {
  if (version != 1 && version != 2)
    throw std::invalid_argument("array::written: no version " + std::to_string(version));
  if (version == 1 && (b.parts.size() != 1 || b.parts[0].encoding != Encoding::u32))
    throw std::invalid_argument("array::written: version 1 holds one geometry with indices of 32 bits");
  Writer to;
  to.bytes(name, sizeof name);
  to.word(version);
  to.word(b.array.records.size());
  to.word(b.array.data.size());
  if (version == 1) {
    to.word(b.parts[0].indices.size() / 4);
    to.word(b.parts[0].base);
  } else {
    to.word(b.parts.size());
    for (const Part& part : b.parts) {
      to.word(static_cast<std::uint32_t>(part.encoding));
      to.word(part.base);
      to.word(part.indices.size() / index_bytes(part.encoding));
    }
  }
  to.bytes(b.array.records.data(), b.array.records.size() * micromap::record_bytes);
  for (const Part& part : b.parts) to.bytes(part.indices.data(), part.indices.size());
  to.bytes(b.array.data.data(), b.array.data.size());
  if (version == 2) to.word(checksum(to.out));
  return std::move(to.out);
}

bool is_container(std::span<const std::uint8_t> file) noexcept {
  return file.size() >= sizeof name && std::memcmp(file.data(), name, sizeof name) == 0;
}

Bundle read(std::span<const std::uint8_t> file) {
  if (!is_container(file)) bad(0, "no array: it does not begin with MMARRAYS");
  Reader from(file);
  from.take(sizeof name, "name");
  const std::uint32_t version = from.word("version");
  if (version != 1 && version != 2)
    bad(8, "version " + std::to_string(version) + ", and this reader knows 1 and 2");
  const std::uint64_t records = from.word("records"), data = from.word("data");
  Bundle b;
  std::vector<std::uint64_t> triangles;
  if (version == 1) {
    triangles.push_back(from.word("triangles"));
    b.parts.push_back({Encoding::u32, from.word("base"), {}});
  } else {
    for (std::uint64_t left = from.word("geometries"); left > 0; --left) {
      const std::size_t at = from.at();
      const std::uint32_t encoding = from.word("encoding");
      if (encoding >= encodings) bad(at, "encoding " + std::to_string(encoding) + " of 0 to 4");
      const std::uint32_t base = from.word("base");
      triangles.push_back(from.word("triangles"));
      b.parts.push_back({static_cast<Encoding>(encoding), base, {}});
    }
  }
  const auto record_bytes = from.take(records * micromap::record_bytes, "records");
  b.array.records.resize(static_cast<std::size_t>(records));
  if (records != 0) std::memcpy(b.array.records.data(), record_bytes.data(), record_bytes.size());
  for (std::size_t p = 0; p < b.parts.size(); ++p) {
    const auto indices = from.take(triangles[p] * index_bytes(b.parts[p].encoding), "indices");
    b.parts[p].indices.assign(indices.begin(), indices.end());
  }
  const auto bytes = from.take(data, "data");
  b.array.data.assign(bytes.begin(), bytes.end());
  if (version == 2) {
    const std::size_t at = from.at();
    if (from.word("checksum") != checksum(file.first(at))) bad(at, "the checksum is another");
  }
  if (from.left() != 0) bad(from.at(), std::to_string(from.left()) + " bytes too many");
  return b;
}

}  // namespace mmverify::impl::array
