#include "scene/read/damaged_picture.hpp"
#include "scene/read/ktx2/etc1s.hpp"
#include "scene/read/word.hpp"

namespace mmverify::scene {
namespace {

constexpr std::size_t global_head = 20, bytes_of_image = 20;

std::vector<Etc1sEnd> take_ends(LowBits bits, std::size_t count) {
  const PrefixCode steps[] = {take_prefix_code(bits), take_prefix_code(bits), take_prefix_code(bits)};
  const PrefixCode table_steps = take_prefix_code(bits);
  const bool is_grey = bits.take(1) != 0;
  // The code of a step depends on the value before it.
  const auto next = [&](std::uint8_t before) {
    const PrefixCode& code = steps[before < 10 ? 0 : before < 22 ? 1 : 2];
    return static_cast<std::uint8_t>((before + code.take(bits)) & 31);
  };
  std::vector<Etc1sEnd> ends;
  Etc1sEnd end{{16, 16, 16}, 0};
  for (std::size_t k = 0; k < count; ++k) {
    end.table = static_cast<std::uint8_t>((end.table + table_steps.take(bits)) & 7);
    if (is_grey)
      end.colour.fill(next(end.colour[0]));
    else
      for (std::uint8_t& channel : end.colour) channel = next(channel);
    ends.push_back(end);
  }
  return ends;
}

std::vector<Etc1sSelectors> take_selectors(LowBits bits, std::size_t count) {
  if (bits.take(2) != 0) throw DamagedPicture("its reserved bits are not 0");
  const bool is_plain = bits.take(1) != 0;
  const PrefixCode changes = is_plain ? PrefixCode() : take_prefix_code(bits);
  std::vector<Etc1sSelectors> all;
  Etc1sSelectors selectors{};
  for (std::size_t k = 0; k < count; ++k) {
    for (std::uint8_t& row : selectors)
      row = static_cast<std::uint8_t>(is_plain || k == 0 ? bits.take(8) : row ^ changes.take(bits));
    all.push_back(selectors);
  }
  return all;
}

/// A slice within level 0.
Ktx2Bytes etc1s_slice(const Ktx2& ktx2, const char* name, std::size_t offset, std::size_t length) {
  if (offset > ktx2.level.size() || length > ktx2.level.size() - offset)
    throw DamagedPicture(std::string(name) + " lies at bytes " + std::to_string(offset) +
                         " of level 0 and has " + std::to_string(length) + ", the level has " +
                         std::to_string(ktx2.level.size()));
  return ktx2.level.subspan(offset, length);
}

void check_global_head(const Ktx2& ktx2) {
  const std::uint64_t due = global_head + bytes_of_image * ktx2.levels;
  if (ktx2.global.size() < due)
    throw DamagedPicture("the supercompression global data of " + std::to_string(ktx2.levels) +
                         " levels have at least " + std::to_string(due) + " bytes, there are " +
                         std::to_string(ktx2.global.size()));
}

}  // namespace

Etc1sCodebooks etc1s_codebooks(const Ktx2& ktx2) {
  check_global_head(ktx2);
  const Ktx2Bytes global = ktx2.global;
  const std::uint32_t counts = word_at(global, 0);
  const std::uint64_t ends = word_at(global, 4), selectors = word_at(global, 8), tables = word_at(global, 12),
                      extended = word_at(global, 16);
  const std::uint64_t start = global_head + bytes_of_image * ktx2.levels;
  if (start + ends + selectors + tables + extended != global.size())
    throw DamagedPicture("the parts of the supercompression global data have " +
                         std::to_string(start + ends + selectors + tables + extended) + " bytes, there are " +
                         std::to_string(global.size()));
  Etc1sCodebooks books;
  books.ends = in_part("the endpoint codebook",
                       [&] { return take_ends(LowBits(global.subspan(start, ends)), counts & 0xffff); });
  books.selectors = in_part("the selector codebook", [&] {
    return take_selectors(LowBits(global.subspan(start + ends, selectors)), counts >> 16);
  });
  in_part("the slices' Huffman tables", [&] {
    LowBits bits(global.subspan(start + ends + selectors, tables));
    books.predictions = take_prefix_code(bits);
    books.end_steps = take_prefix_code(bits);
    books.selector_symbols = take_prefix_code(bits);
    books.run_lengths = take_prefix_code(bits);
    books.history = bits.take(13);
  });
  return books;
}

Etc1sSlices etc1s_slices(const Ktx2& ktx2) {
  check_global_head(ktx2);
  const auto image_word = [&](std::size_t k) { return word_at(ktx2.global, global_head + 4 * k); };
  constexpr std::uint32_t depends_on_another = 2;
  if ((image_word(0) & depends_on_another) != 0) throw DamagedPicture("level 0 is a P-frame of no video");
  if (image_word(2) == 0) throw DamagedPicture("the slice of colours has no bytes");
  if (ktx2.has_alpha_slice != (image_word(4) != 0))
    throw DamagedPicture(ktx2.has_alpha_slice ? "the slice of alpha has no bytes"
                                              : "a slice of alpha that the data format descriptor lacks");
  return {etc1s_slice(ktx2, "the slice of colours", image_word(1), image_word(2)),
          etc1s_slice(ktx2, "the slice of alpha", image_word(3), image_word(4))};
}

}  // namespace mmverify::scene
