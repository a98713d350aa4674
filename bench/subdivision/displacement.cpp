#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

#include "bench/subdivision/bench.hpp"
#include "impl/index/index.hpp"

namespace mmverify::bench {
namespace {

/// The least and the greatest code of a micro-triangle.
struct Range {
  std::uint32_t least, greatest;
  friend bool operator==(const Range&, const Range&) = default;
};
/// A range for each micro-triangle, in the order of the curve.
using Map = std::vector<Range>;

// ---- Heights in [0, 1]

/// A number in [0, 1) of a grid point, an octave and a seed.
double noise_at(std::uint64_t seed, std::uint32_t octave, std::uint32_t x, std::uint32_t y) {
  std::uint64_t z = seed * 0x9E3779B97F4A7C15u + (std::uint64_t{octave} << 58) + (std::uint64_t{x} << 29) + y;
  z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
  z = (z ^ z >> 27) * 0x94D049BB133111EBu;
  return static_cast<double>((z ^ z >> 31) >> 11) * 0x1p-53;
}

/// Octaves of noise between grid points, each with twice as many of them and half the height.
double terrain(double u, double v, std::uint64_t seed) {
  double sum = 0, height = 0.5;
  for (std::uint32_t octave = 1; octave <= 9; ++octave, height /= 2) {
    const double x = u * (1u << octave), y = v * (1u << octave), i = std::floor(x), j = std::floor(y),
                 a = x - i, b = y - j;
    const auto at = [&](std::uint32_t across, std::uint32_t up) {
      return noise_at(seed, octave, static_cast<std::uint32_t>(i) + across,
                      static_cast<std::uint32_t>(j) + up);
    };
    sum += height * ((at(0, 0) * (1 - a) + at(1, 0) * a) * (1 - b) + (at(0, 1) * (1 - a) + at(1, 1) * a) * b);
  }
  return sum;
}

/// (1 - d^2)^2 of the distance d from a centre in radii; 0 beyond.
double mound(double u, double v, double x, double y, double radius) {
  const double d2 = ((u - x) * (u - x) + (v - y) * (v - y)) / (radius * radius);
  return d2 < 1 ? (1 - d2) * (1 - d2) : 0;
}

double bumps(double u, double v, std::uint64_t) {
  double sum = 0;
  for (const auto& [x, y] : {std::pair{0.2, 0.2}, {0.6, 0.1}, {0.15, 0.65}, {0.4, 0.4}})
    sum = std::max(sum, mound(u, v, x, y, 0.35));
  return sum;
}

double plain(double u, double v, std::uint64_t) { return mound(u, v, 0.3, 0.3, 0.2); }

struct Field {
  const char* name;
  double (*height)(double u, double v, std::uint64_t seed);
};
constexpr Field fields[] = {{"terrain", terrain}, {"bumps", bumps}, {"plain", plain}};

/// Heights at the micro-vertices of three levels more: 45 of each micro-triangle.
constexpr std::uint32_t finer = 3;

Map map_of(const Field& field, std::uint32_t bits, std::uint32_t level, std::uint64_t seed) {
  constexpr std::int32_t parts = 1 << finer;
  const double most = std::exp2(bits) - 1, side = std::exp2(level + finer);
  Map map;
  for (std::uint32_t k = 0; k < 1u << 2 * level; ++k) {
    const auto p = impl::index::corners(k, level);
    double least = 1, greatest = 0;
    for (std::int32_t i = 0; i <= parts; ++i)
      for (std::int32_t j = 0; i + j <= parts; ++j) {
        const auto across = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
          return (static_cast<std::int32_t>(a) * (parts - i - j) + static_cast<std::int32_t>(b) * i +
                  static_cast<std::int32_t>(c) * j) /
                 side;
        };
        const double h = field.height(across(p[0].i, p[1].i, p[2].i), across(p[0].j, p[1].j, p[2].j), seed);
        least = std::min(least, h);
        greatest = std::max(greatest, h);
      }
    map.push_back({static_cast<std::uint32_t>(std::floor(least * most)),
                   static_cast<std::uint32_t>(std::ceil(greatest * most))});
  }
  return map;
}

// ---- Forms

/// Bits one after another.
class Bits {
 public:
  void write(std::uint32_t value, std::uint32_t width) {
    for (std::uint32_t k = 0; k < width; ++k) bits_.push_back((value >> k & 1) != 0);
  }
  std::uint32_t read(std::uint32_t width) {
    std::uint32_t value = 0;
    for (std::uint32_t k = 0; k < width; ++k) value |= std::uint32_t{bits_[at_++]} << k;
    return value;
  }
  std::uint64_t bytes() const { return (bits_.size() + 7) / 8; }

 private:
  std::vector<bool> bits_;
  std::size_t at_ = 0;
};

/// A tree of two sequences, as impl/tree's stream: a bit a node in pre-order, and beside them the leaves' pairs.
class MergedTree {
 public:
  MergedTree(const Map& map, std::uint32_t bits) : bits_(bits) { write(map, 0, map.size()); }
  std::uint64_t bytes() const { return tree_.bytes() + data_.bytes(); }
  Map decoded(std::size_t size) {
    Map map;
    read(map, size);
    return map;
  }

 private:
  void write(const Map& map, std::size_t at, std::size_t size) {
    const auto first = map.begin() + static_cast<std::ptrdiff_t>(at);
    const bool leaf = std::all_of(first, first + static_cast<std::ptrdiff_t>(size),
                                  [&](const Range& r) { return r == *first; });
    tree_.write(leaf ? 0 : 1, 1);
    if (leaf) {
      data_.write(first->least, bits_);
      data_.write(first->greatest, bits_);
      return;
    }
    for (std::size_t c = 0; c < 4; ++c) write(map, at + c * size / 4, size / 4);
  }
  void read(Map& map, std::size_t size) {
    if (tree_.read(1) == 0) {
      const std::uint32_t least = data_.read(bits_);
      map.insert(map.end(), size, Range{least, data_.read(bits_)});
      return;
    }
    for (std::size_t c = 0; c < 4; ++c) read(map, size / 4);
  }

  std::uint32_t bits_;
  Bits tree_, data_;
};

/// A tree of ranges: the root's pair, and each node's as differences from its parent's two codes, in the bits of the
/// parent's range.  A node without a range has no children: they are like it.
class NarrowingTree {
 public:
  NarrowingTree(const Map& map, std::uint32_t bits) : whole_{0, (1u << bits) - 1} {
    write(map, 0, map.size(), whole_);
  }
  std::uint64_t bytes() const { return bits_.bytes(); }
  Map decoded(std::size_t size) {
    Map map;
    read(map, size, whole_);
    return map;
  }

 private:
  static std::uint32_t width(const Range& r) {
    return static_cast<std::uint32_t>(std::bit_width(r.greatest - r.least));
  }
  void write(const Map& map, std::size_t at, std::size_t size, const Range& parent) {
    Range range = map[at];
    for (std::size_t k = at; k < at + size; ++k)
      range = {std::min(range.least, map[k].least), std::max(range.greatest, map[k].greatest)};
    bits_.write(range.least - parent.least, width(parent));
    bits_.write(parent.greatest - range.greatest, width(parent));
    if (size == 1 || range.least == range.greatest) return;
    for (std::size_t c = 0; c < 4; ++c) write(map, at + c * size / 4, size / 4, range);
  }
  void read(Map& map, std::size_t size, const Range& parent) {
    const std::uint32_t least = parent.least + bits_.read(width(parent));
    const Range range{least, parent.greatest - bits_.read(width(parent))};
    if (size == 1 || range.least == range.greatest) {
      map.insert(map.end(), size, range);
      return;
    }
    for (std::size_t c = 0; c < 4; ++c) read(map, size / 4, range);
  }

  Range whole_;
  Bits bits_;
};

template <class Tree>
std::uint64_t bytes_of(const Map& map, std::uint32_t bits) {
  Tree tree(map, bits);
  const std::uint64_t bytes = tree.bytes();
  if (tree.decoded(map.size()) != map)
    throw std::runtime_error("subdivision bench: a tree gives another map back");
  return bytes;
}

}  // namespace

std::vector<DisplacementSizes> displacement_sizes(const SubdivisionBenchOptions& options) {
  constexpr std::uint32_t last = 6;
  std::vector<DisplacementSizes> all;
  for (const Field& field : fields) {
    if (options.progress) options.progress(std::string("displacements, ") + field.name);
    for (const std::uint32_t bits : {8u, 11u})
      for (std::uint32_t level = 1; level <= last; ++level) {
        const Map map = map_of(field, bits, level, options.seed);
        all.push_back({field.name, bits, level, (2 * bits * map.size() + 7) / 8,
                       bytes_of<MergedTree>(map, bits), bytes_of<NarrowingTree>(map, bits)});
      }
  }
  return all;
}

}  // namespace mmverify::bench
