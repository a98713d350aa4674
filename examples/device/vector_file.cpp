#include "vector_file.hpp"

#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace rays {
namespace {

constexpr std::size_t entry_size = 64;    // of the table of contents
constexpr std::size_t point_size = 64;    // of index.points
constexpr std::size_t corners_size = 36;  // of corners.curve
constexpr std::uint32_t on_edge = 1, on_vertex = 2, outside = 3;

struct Section {
  std::size_t at = 0, record = 0, count = 0;
};

class File {
 public:
  explicit File(const std::string& path) : path_(path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) fail("it cannot be read");
    try {
      bytes_.assign(std::istreambuf_iterator<char>(in), {});
    } catch (const std::ios_base::failure&) {  // a folder opens, but has no bytes
      fail("it cannot be read");
    }
    if (bytes_.size() < 128 || text(0, 8) != "MMVECTOR" || word(8) != 2 || word(20) != bytes_.size())
      fail("not the whole of a mmverify_vectors.bin, version 2");
  }

  [[noreturn]] void fail(const std::string& why) const { throw std::runtime_error(path_ + ": " + why); }

  std::uint32_t word(std::size_t at) const {
    need(at, 4);
    std::uint32_t found = 0;
    for (unsigned k = 0; k < 4; ++k)
      found |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_[at + k])) << 8 * k;
    return found;
  }

  /// The text at that place, to its first zero.
  std::string text(std::size_t at, std::size_t size) const {
    need(at, size);
    const std::string_view whole(bytes_.data() + at, size);
    return std::string(whole.substr(0, whole.find('\0')));
  }

  /// A part of a family, whose records have at least so many bytes.
  Section section(const std::string& family, const std::string& name, std::size_t least) const {
    for (std::size_t k = 0; k < word(12); ++k) {
      const std::size_t at = word(16) + entry_size * k;
      if (text(at, 16) != family || text(at + 16, 16) != name) continue;
      const Section found{word(at + 44), word(at + 36), word(at + 40)};
      if (found.record < least) fail(family + "." + name + " has too few columns");
      need(found.at, found.record * found.count);
      return found;
    }
    fail("no " + family + "." + name + "; mmverify vectors --family index,corners writes it");
  }

 private:
  void need(std::size_t at, std::size_t size) const {
    if (at > bytes_.size() || size > bytes_.size() - at) fail("a place beyond its end");
  }

  std::string path_;
  std::vector<char> bytes_;
};

Point point(const File& file, std::size_t at, const Section& data, const Section& about) {
  Point found;
  found.level = file.word(at + 4);
  found.u = std::bit_cast<float>(file.word(at + 8));
  found.v = std::bit_cast<float>(file.word(at + 12));
  found.tie = file.word(at + 16) == on_edge || file.word(at + 16) == on_vertex;
  found.gap = std::bit_cast<float>(file.word(at + 20));
  found.index = file.word(at + 24);
  const std::size_t touched = file.word(at + 48), size = file.word(at + 52), whole = data.record * data.count;
  if (touched > whole || size > whole - touched) file.fail("micro-triangles beyond the family's data");
  for (std::size_t k = 0; k < size; k += 4) found.touched.push_back(file.word(data.at + touched + k));
  if (file.word(at) >= about.count) file.fail("a vector has no reason");
  found.about = file.text(about.at + about.record * file.word(at), about.record);
  return found;
}

/// The centroid of a micro-triangle, from its index and its corners in steps of 1/N.
Point centroid(const File& file, std::size_t at) {
  Point found;
  found.level = file.word(at + 4);
  found.index = file.word(at + 8);
  const double thirds = std::ldexp(3.0, static_cast<int>(found.level));
  found.u = static_cast<float>((file.word(at + 12) + file.word(at + 20) + file.word(at + 28)) / thirds);
  found.v = static_cast<float>((file.word(at + 16) + file.word(at + 24) + file.word(at + 32)) / thirds);
  // 1/3 less what rounding to binary32 moves: 2^-25 twice, in edges of level 16 or longer ones.
  found.gap = 0.32f;
  found.about = "centroid of a micro-triangle";
  return found;
}

}  // namespace

std::vector<Point> read_points(const std::string& path) {
  const File file(path);
  const Section points = file.section("index", "points", point_size), data = file.section("index", "data", 1),
                about = file.section("index", "about", 1),
                corners = file.section("corners", "curve", corners_size);
  std::vector<Point> found;
  for (std::size_t k = 0; k < corners.count; ++k)
    found.push_back(centroid(file, corners.at + corners.record * k));
  for (std::size_t k = 0; k < points.count; ++k)
    if (const std::size_t at = points.at + points.record * k; file.word(at + 16) != outside)
      found.push_back(point(file, at, data, about));
  return found;
}

}  // namespace rays
