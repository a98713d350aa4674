#include "impl/tree/tree.hpp"

#include <algorithm>
#include <memory>
#include <random>
#include <stdexcept>

#include "bench/textures/alpha_textures.hpp"
#include "bench/tree/maps.hpp"
#include "bench/tree/textures.hpp"
#include "cli/bench/codec/codec.hpp"
#include "impl/micromap/micromap.hpp"

namespace mmverify::cli::codec::of_tree {
namespace {

using impl::tree::Format;
using impl::tree::Level;
using impl::tree::Tree;
using Map = std::vector<std::uint8_t>;

constexpr std::size_t lookups_a_map = 4096;

/// The maps of a row, what both codecs made of them, and the places that are looked up.
struct Row {
  Level level;
  Format format;
  std::vector<Map> maps = {}, codes = {}, back = {};
  std::vector<std::size_t> sizes = {};
  std::vector<Tree> trees = {};
  std::vector<std::uint32_t> index = {};
  std::vector<std::uint8_t> state = {};

  unsigned bits() const { return static_cast<unsigned>(format); }
};

bench::CodecWork theirs(const mmverify_subject_t& s, const std::shared_ptr<Row>& row) {
  bench::CodecWork work;
  work.encode = [&s, row] {
    for (std::size_t k = 0; k < row->maps.size(); ++k)
      row->sizes[k] = encoded(row->codes[k], [&](std::uint8_t* code, std::size_t capacity) {
        return s.tree_encode(row->level, row->bits(), row->maps[k].data(), code, capacity);
      });
  };
  if (s.tree_decode != nullptr)
    work.decode = [&s, row] {
      for (std::size_t k = 0; k < row->maps.size(); ++k)
        if (s.tree_decode(row->level, row->bits(), row->codes[k].data(), row->sizes[k],
                          row->back[k].data()) == 0)
          row->back[k].assign(row->back[k].size(), 0);
    };
  if (s.tree_lookup != nullptr)
    work.look_up = [&s, row] {
      for (std::size_t k = 0; k < row->maps.size(); ++k)
        s.tree_lookup(row->level, row->bits(), row->codes[k].data(), row->sizes[k], row->index.data(),
                      row->state.data(), row->index.size());
    };
  work.bits = [row] {
    double all = 0;
    for (const std::size_t size : row->sizes) all += 8 * static_cast<double>(size);
    return all;
  };
  if (s.tree_lookup != nullptr)
    work.wrong_lookups = [&s, row] {
      std::uint64_t wrong = 0;
      for (std::size_t k = 0; k < row->maps.size(); ++k) {
        s.tree_lookup(row->level, row->bits(), row->codes[k].data(), row->sizes[k], row->index.data(),
                      row->state.data(), row->index.size());
        std::vector<std::uint8_t> right(row->index.size());
        row->trees[k].lookup(row->index, right);
        for (std::size_t t = 0; t < right.size(); ++t) wrong += right[t] != row->state[t] ? 1 : 0;
      }
      return wrong;
    };
  if (work.decode)
    work.changed = [row, decode = work.decode] {
      std::uint64_t changed = 0;
      decode();  // ours wrote there since
      for (std::size_t k = 0; k < row->maps.size(); ++k)
        changed += differing(row->back[k], row->maps[k], row->bits());
      return changed;
    };
  else
    work.changed = work.wrong_lookups;
  return work;
}

bench::CodecWork ours(const std::shared_ptr<Row>& row) {
  const auto encode = [row] {
    row->trees.clear();
    for (const Map& map : row->maps) row->trees.push_back(Tree::encode(row->level, row->format, map));
  };
  return {.encode = encode,
          .decode =
              [row] {
                for (std::size_t k = 0; k < row->maps.size(); ++k) row->trees[k].decode(row->back[k]);
              },
          .look_up =
              [row] {
                for (const Tree& tree : row->trees) tree.lookup(row->index, row->state);
              },
          .bits =
              [row] {
                double all = 0;
                for (const Tree& tree : row->trees) all += static_cast<double>(tree.bits());
                return all;
              },
          .changed =
              [row] {
                std::uint64_t changed = 0;
                for (std::size_t k = 0; k < row->maps.size(); ++k) {
                  row->trees[k].decode(row->back[k]);
                  changed += differing(row->back[k], row->maps[k], row->bits());
                }
                return changed;
              }};
}

bench::CodecCase of_maps(const Asked& asked, std::string of, Level level, Format format,
                         std::vector<Map> maps) {
  const std::uint64_t states = impl::micromap::micro_triangles(level);
  auto row = std::make_shared<Row>(Row{.level = level, .format = format, .maps = std::move(maps)});
  row->codes.assign(row->maps.size(), Map(4 * row->maps.front().size() + 64));
  row->back = row->maps;
  row->sizes.resize(row->maps.size());
  row->index = random_below(static_cast<std::uint32_t>(states), lookups_a_map, asked.options.index.seed);
  row->state.resize(lookups_a_map);
  return {.of = std::move(of),
          .level = level,
          .states = format == Format::two_state ? 2u : 4u,
          .maps = row->maps.size(),
          .micro_triangles = states * row->maps.size(),
          .lookups = lookups_a_map * row->maps.size(),
          .theirs = theirs(asked.subject, row),
          .ours = ours(row)};
}

/// Maps of states drawn one by one.
Map noise(Level level, Format format, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  Map map(impl::micromap::packed_bytes(impl::micromap::micro_triangles(level),
                                       static_cast<impl::micromap::Format>(format)));
  for (std::uint8_t& byte : map) byte = static_cast<std::uint8_t>(random());
  if (map.size() == 1 && level == 0)
    map[0] &= static_cast<std::uint8_t>(2u * static_cast<unsigned>(format) - 1);
  if (level == 1 && format == Format::two_state) map[0] &= 15;
  return map;
}

}  // namespace

void cases(const Asked& asked) {
  if (asked.subject.tree_encode == nullptr)
    throw std::runtime_error(asked.options.subject + ": no tree_encode");
  std::vector<bench::AlphaTexture> textures;
  if (!asked.options.textures.empty()) textures = bench::alpha_textures(asked.options.textures);
  const std::uint64_t seed = asked.options.index.seed;
  for (const Format format : {Format::two_state, Format::four_state})
    for (Level n = asked.levels.first; n <= std::min<Level>(asked.levels.last, asked.subject.max_level);
         ++n) {
      for (const bench::AlphaTexture& texture : textures)
        asked.take(of_maps(asked, texture.file, n, format, bench::texture_maps({texture}, n, format)));
      if (!textures.empty()) continue;
      std::vector<Map> leaves, noises;
      for (std::uint64_t k = 0; k < 8; ++k) leaves.push_back(bench::leaf_map(n, format, seed + k));
      for (std::uint64_t k = 0; k < 4; ++k) noises.push_back(noise(n, format, seed + k));
      asked.take(of_maps(asked, "leaves", n, format, std::move(leaves)));
      asked.take(of_maps(asked, "noise", n, format, std::move(noises)));
    }
}

}  // namespace mmverify::cli::codec::of_tree
