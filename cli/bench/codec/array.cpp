#include <cstring>
#include <memory>
#include <stdexcept>

#include "bench/tree/maps.hpp"
#include "cli/bench/codec/codec.hpp"
#include "impl/array/build.hpp"

namespace mmverify::cli::codec::of_array {
namespace {

namespace array = impl::array;
using Map = std::vector<std::uint8_t>;

constexpr std::uint32_t triangles = 1024;

struct Row {
  std::vector<Map> maps;
  std::vector<array::PackedMap> packed;
  std::vector<mmverify_array_triangle_t> described;
  std::vector<std::uint8_t> bytes, answer;  ///< bytes: of all maps, as array_build takes them
  mmverify_array_case_t what{};
  std::size_t size = 0;
  array::Built built;
};

/// Maps of one level: of each three one is new, and two are it again.
std::shared_ptr<Row> row_of(std::uint32_t level, std::uint64_t seed) {
  auto row = std::make_shared<Row>();
  for (std::uint32_t t = 0; t < triangles; ++t)
    row->maps.push_back(t % 3 == 0
                            ? bench::leaf_map(level, impl::tree::Format::four_state, seed * 1'000'003 + t)
                            : row->maps[t / 3 * 3]);
  for (const Map& map : row->maps) {
    row->packed.push_back({level, array::Format::four_state, map});
    row->described.push_back({level, MMVERIFY_4_STATE, static_cast<std::uint32_t>(row->bytes.size())});
    row->bytes.insert(row->bytes.end(), map.begin(), map.end());
  }
  row->what.size = sizeof row->what;
  row->what.api = MMVERIFY_ARRAY_EXT;
  row->what.index_type = MMVERIFY_INDEX_U32;
  row->what.flags = MMVERIFY_ARRAY_SPECIAL | MMVERIFY_ARRAY_SHARE;
  row->what.count = triangles;
  row->what.triangles = row->described.data();
  row->what.maps = row->bytes.data();
  row->answer.resize(2 * row->bytes.size() + (std::size_t{1} << 16));
  return row;
}

}  // namespace

void cases(const Asked& asked) {
  const mmverify_subject_t& s = asked.subject;
  if (s.array_build == nullptr) throw std::runtime_error(asked.options.subject + ": no array_build");
  for (std::uint32_t n = asked.levels.first; n <= asked.levels.last; ++n) {
    const auto row = row_of(n, asked.options.index.seed);
    bench::CodecCase c{.of = "leaves, thrice each",
                       .level = n,
                       .states = 4,
                       .maps = triangles,
                       .micro_triangles = std::uint64_t{triangles} << 2 * n};
    c.theirs.encode = [&s, row] {
      row->size = encoded(row->answer, [&](std::uint8_t* answer, std::size_t capacity) {
        return s.array_build(&row->what, answer, capacity);
      });
    };
    c.theirs.bits = [row] {
      mmverify_array_answer_t head{};
      if (row->size >= sizeof head) std::memcpy(&head, row->answer.data(), sizeof head);
      return 8 * (8.0 * head.records + head.index_bytes + head.data_bytes);
    };
    c.ours.encode = [row] {
      row->built = array::build({}, row->packed, {.api = array::Api::EXT, .encoding = array::Encoding::u32});
    };
    c.ours.bits = [row] {
      return 8.0 * static_cast<double>(8 * row->built.array.records.size() + row->built.part.indices.size() +
                                       row->built.array.data.size());
    };
    asked.take(c);
  }
}

}  // namespace mmverify::cli::codec::of_array
