#include "impl/dag/dag.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "bench/tree/maps.hpp"
#include "cli/bench/codec/codec.hpp"
#include "impl/micromap/micromap.hpp"

namespace mmverify::cli::codec::of_dag {
namespace {

using impl::dag::Dag;
using impl::dag::Format;
using Map = std::vector<std::uint8_t>;

constexpr std::size_t lookups = 1 << 16;

/// A scene's maps of one level: distinct leaves, and a fifth of them twice.
struct Row {
  std::uint32_t level;
  Format format;
  std::vector<Map> maps = {};
  std::vector<std::uint8_t> scene = {}, code = {}, back = {};  ///< scene: as dag_encode takes it
  std::size_t size = 0, back_size = 0;
  std::unique_ptr<Dag> graph = {};
  std::vector<std::uint32_t> map = {}, index = {};
  std::vector<std::uint8_t> state = {};

  unsigned bits() const { return static_cast<unsigned>(format); }
};

std::shared_ptr<Row> row_of(std::uint32_t level, Format format, std::uint64_t seed) {
  constexpr std::size_t count = 40;
  auto row = std::make_shared<Row>(Row{.level = level, .format = format});
  for (std::size_t k = 0; k < count; ++k)
    row->maps.push_back(k % 5 == 4
                            ? row->maps[k - 4]
                            : bench::leaf_map(level, static_cast<impl::tree::Format>(format), seed + k));
  for (const Map& map : row->maps) {
    row->scene.push_back(static_cast<std::uint8_t>(level));
    row->scene.insert(row->scene.end(), map.begin(), map.end());
  }
  row->code.resize(2 * row->scene.size() + 4096);
  row->back.resize(row->scene.size());
  row->map = random_below(count, lookups, seed);
  row->index = random_below(std::uint32_t{1} << 2 * level, lookups, seed + 1);
  row->state.resize(lookups);
  return row;
}

bench::CodecWork theirs(const mmverify_subject_t& s, const std::shared_ptr<Row>& row) {
  bench::CodecWork work;
  work.encode = [&s, row] {
    row->size = encoded(row->code, [&](std::uint8_t* code, std::size_t capacity) {
      return s.dag_encode(row->bits(), row->scene.data(), row->scene.size(), code, capacity);
    });
  };
  if (s.dag_decode != nullptr)
    work.decode = [&s, row] {
      row->back_size =
          s.dag_decode(row->bits(), row->code.data(), row->size, row->back.data(), row->back.size());
    };
  if (s.dag_lookup != nullptr)
    work.look_up = [&s, row] {
      s.dag_lookup(row->bits(), row->code.data(), row->size, row->map.data(), row->index.data(),
                   row->state.data(), row->state.size());
    };
  work.bits = [row] { return 8 * static_cast<double>(row->size); };
  if (s.dag_lookup != nullptr)
    work.wrong_lookups = [row] {
      std::uint64_t wrong = 0;
      for (std::size_t k = 0; k < row->state.size(); ++k)
        wrong += row->graph->at(row->map[k], row->index[k]) != row->state[k] ? 1 : 0;
      return wrong;
    };
  work.changed = work.wrong_lookups;
  if (s.dag_decode != nullptr)
    work.changed = [row] {
      return row->back_size == row->scene.size() ? differing(row->back, row->scene, row->bits())
                                                 : std::uint64_t{row->scene.size()};
    };
  return work;
}

bench::CodecWork ours(const std::shared_ptr<Row>& row) {
  return {.encode =
              [row] {
                row->graph = std::make_unique<Dag>(row->format);
                for (const Map& map : row->maps) row->graph->add(row->level, map);
              },
          .decode =
              [row] {
                Map out(row->maps.front().size());
                for (std::uint32_t k = 0; k < row->maps.size(); ++k) row->graph->decode(k, out);
              },
          .look_up =
              [row] {
                std::vector<std::uint8_t> state(row->state.size());
                row->graph->lookup(row->map, row->index, state);
              },
          .bits = [row] { return static_cast<double>(row->graph->bits()); },
          .changed =
              [row] {
                std::uint64_t changed = 0;
                Map out(row->maps.front().size());
                for (std::uint32_t k = 0; k < row->maps.size(); ++k) {
                  row->graph->decode(k, out);
                  changed += differing(out, row->maps[k], row->bits());
                }
                return changed;
              }};
}

}  // namespace

void cases(const Asked& asked) {
  const mmverify_subject_t& s = asked.subject;
  if (s.dag_encode == nullptr) throw std::runtime_error(asked.options.subject + ": no dag_encode");
  for (const Format format : {Format::two_state, Format::four_state})
    for (std::uint32_t n = asked.levels.first; n <= std::min(asked.levels.last, s.max_level); ++n) {
      const auto row = row_of(n, format, asked.options.index.seed);
      asked.take({.of = "leaves, a fifth twice",
                  .level = n,
                  .states = format == Format::two_state ? 2u : 4u,
                  .maps = row->maps.size(),
                  .micro_triangles = row->maps.size() * impl::micromap::micro_triangles(n),
                  .lookups = lookups,
                  .theirs = theirs(s, row),
                  .ours = ours(row)});
    }
}

}  // namespace mmverify::cli::codec::of_dag
