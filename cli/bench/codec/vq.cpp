#include "impl/vq/vq.hpp"

#include <memory>
#include <stdexcept>

#include "bench/vq/maps.hpp"
#include "cli/bench/codec/codec.hpp"

namespace mmverify::cli::codec::of_vq {
namespace {

using impl::vq::State;

constexpr std::size_t lookups = 1 << 16;

/// One format of square maps: its header's entry points, and ours.
template <class Map, class Block>
struct SquareFormat {
  const char* name;
  std::uint32_t side;
  void (*encode)(const std::uint8_t*, std::uint8_t*);
  void (*decode)(const std::uint8_t*, std::uint8_t*);
  void (*region)(const std::uint8_t*, const std::uint32_t*, const std::uint32_t*, std::uint8_t*, std::size_t);
  Block (*our_block)(const Map&);
};

template <class Map, class Block>
struct Row {
  SquareFormat<Map, Block> form;
  Map map;
  std::array<std::uint8_t, std::tuple_size_v<Map>> bytes{}, back{};
  Block block{}, our_block{};
  std::vector<std::uint32_t> x, y;
  std::vector<std::uint8_t> state = std::vector<std::uint8_t>(lookups);
};

/// Regions of a block that are not the map's; a block that turns T into O, or C into either, counts them, too.
template <class Map, class Block>
std::uint64_t lost(const Row<Map, Block>& row, const Block& block) {
  const Map out = impl::vq::decode(block);
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < out.size(); ++k) count += out[k] != row.map[k] ? 1 : 0;
  return count;
}

template <class Map, class Block>
bench::CodecCase case_of(const std::string& of, const Map& map, const SquareFormat<Map, Block>& form,
                         std::uint64_t seed) {
  auto row = std::make_shared<Row<Map, Block>>();
  row->form = form, row->map = map;
  for (std::size_t k = 0; k < map.size(); ++k) row->bytes[k] = static_cast<std::uint8_t>(map[k]);
  row->x = random_below(form.side, lookups, seed), row->y = random_below(form.side, lookups, seed + 1);
  row->block = row->our_block = form.our_block(map);
  bench::CodecCase c{.of = std::string(form.name) + " " + of,
                     .states = 3,
                     .micro_triangles = map.size(),
                     .lookups = lookups};
  if (form.encode != nullptr) {
    c.theirs.encode = [row] { row->form.encode(row->bytes.data(), row->block.data()); };
    c.theirs.changed = [row] { return lost(*row, row->block); };
  }
  if (form.decode != nullptr)
    c.theirs.decode = [row] { row->form.decode(row->block.data(), row->back.data()); };
  if (form.region != nullptr) {
    c.theirs.look_up = [row] {
      row->form.region(row->block.data(), row->x.data(), row->y.data(), row->state.data(), lookups);
    };
    c.theirs.wrong_lookups = [row, look_up = c.theirs.look_up] {
      look_up();  // ours wrote there since
      const Map right = impl::vq::decode(row->block);
      std::uint64_t wrong = 0;
      for (std::size_t k = 0; k < lookups; ++k)
        wrong +=
            row->state[k] != static_cast<std::uint8_t>(right[row->x[k] + row->form.side * row->y[k]]) ? 1 : 0;
      return wrong;
    };
  }
  c.ours = {.encode = [row] { row->our_block = row->form.our_block(row->map); },
            .decode =
                [row] {
                  const Map out = impl::vq::decode(row->our_block);
                  row->back[0] = static_cast<std::uint8_t>(out[0]);
                },
            .look_up =
                [row] {
                  for (std::size_t k = 0; k < lookups; ++k)
                    row->state[k] =
                        static_cast<std::uint8_t>(impl::vq::region(row->our_block, row->x[k], row->y[k]));
                },
            .bits = [] { return 8.0 * sizeof(Block); },
            .changed = [row] { return lost(*row, row->our_block); }};
  // A decoder alone gets our block.
  if (form.encode == nullptr && form.decode != nullptr)
    c.theirs.changed = [row] {
      row->form.decode(row->block.data(), row->back.data());
      const Map right = impl::vq::decode(row->block);
      std::uint64_t changed = 0;
      for (std::size_t k = 0; k < right.size(); ++k)
        changed += row->back[k] != static_cast<std::uint8_t>(right[k]) ? 1 : 0;
      return changed;
    };
  c.theirs.bits = c.ours.bits;
  return c;
}

}  // namespace

void cases(const Asked& asked) {
  const mmverify_subject_t& s = asked.subject;
  using impl::vq::Block2, impl::vq::Block4, impl::vq::Map2, impl::vq::Map4;
  const bool two = s.vq2_encode != nullptr || s.vq2_decode != nullptr || s.vq2_region != nullptr;
  const bool four = s.vq4_encode != nullptr || s.vq4_decode != nullptr || s.vq4_region != nullptr;
  if (!two && !four)
    throw std::runtime_error(asked.options.subject + ": no vq2_encode, vq4_encode or decoder");
  const SquareFormat<Map2, Block2> form2{
      "VQ2",        16,           s.vq2_encode,
      s.vq2_decode, s.vq2_region, [](const Map2& m) { return impl::vq::encode_optimal(m).block; }};
  const SquareFormat<Map4, Block4> form4{
      "VQ4",        32,
      s.vq4_encode, s.vq4_decode,
      s.vq4_region, [](const Map4& m) { return impl::vq::encode(m, impl::vq::Effort::balanced).block; }};
  const std::uint64_t seed = asked.options.index.seed;
  const std::vector<bench::OpacityMaps> all =
      asked.options.textures.empty()
          ? bench::leaf_opacity_maps(asked.options.maps == 0 ? 12 : asked.options.maps, seed)
          : bench::opacity_maps(bench::alpha_textures(asked.options.textures));
  for (const bench::OpacityMaps& maps : all) {
    if (two) asked.take(case_of(maps.of, maps.regions_16, form2, seed));
    if (four) asked.take(case_of(maps.of, maps.regions_32, form4, seed));
  }
}

}  // namespace mmverify::cli::codec::of_vq
