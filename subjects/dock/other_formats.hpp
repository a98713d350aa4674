// Other valid formats of an entry point for the same numbers, map, code or array.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "subjects/dock/entry_points.hpp"

namespace mmverify::dock {

/// Other values of `format` that the header allows with the same numbers or bytes, or with those of
/// as_of_format(): orders, roundings, operations, edges, modes, versions, levels of the result. None if the
/// header allows only some inputs, such as codes for lookups: a worker then repeats an earlier question.
inline std::vector<std::uint32_t> other_formats(Call call, std::uint32_t level, std::uint32_t format) {
  std::vector<std::uint32_t> others;
  const auto from_to = [&](std::uint32_t first, std::uint32_t last) {
    for (std::uint32_t f = first; f <= last; ++f)
      if (f != format) others.push_back(f);
  };
  constexpr std::uint32_t orders = 3;
  const auto second_orders = [&] {
    for (std::uint32_t order = 0; order < orders; ++order)
      if (order != format / formats_side) others.push_back(two_formats(format % formats_side, order));
  };
  switch (call) {
    case Call::attribute_vertex_index:
    case Call::attribute_vertex_place:
    case Call::attribute_face_index:
    case Call::attribute_face_place:
    case Call::attribute_triplet_f32: from_to(0, orders - 1); break;
    case Call::attribute_triplet:
      second_orders();
      for (std::uint32_t order = 0; order < orders; ++order)
        if (order != format % formats_side) others.push_back(two_formats(order, format / formats_side));
      break;
    case Call::attribute_face_of:  // its vertices are a face's only in their own order
      second_orders();
      break;
    case Call::attribute_decimate:
      from_to(0, MMVERIFY_EDGE_W_U | MMVERIFY_EDGE_U_V | MMVERIFY_EDGE_V_W);
      break;
    case Call::attribute_face_mip: from_to(MMVERIFY_ROUND_HALF_UP, MMVERIFY_ROUND_HALVES_UP); break;
    case Call::traverse_blend: from_to(MMVERIFY_BLEND_MAX, MMVERIFY_BLEND_OVER); break;
    case Call::micromap_through: from_to(0, 2); break;
    case Call::array_emulate:
      if (level > 0) from_to(0, level - 1);
      break;
    case Call::tree_encode:
    case Call::tree_decode:
    case Call::micromap_pack:
    case Call::micromap_unpack:
    case Call::micromap_up:
    case Call::micromap_down:
    case Call::dag_decode: from_to(MMVERIFY_2_STATE, MMVERIFY_4_STATE); break;
    case Call::array_save: from_to(1, 2); break;
    default: break;
  }
  return others;
}

/// The bytes of a question, adapted to another format. A map is repeated to the size that the format takes,
/// without bits after its last state; states are limited to those of the format; other bytes stay. Domain:
/// other_formats() has `format`.
inline std::vector<std::uint8_t> as_of_format(Call call, std::uint32_t level, std::uint32_t format,
                                              std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> as(bytes.begin(), bytes.end());
  switch (call) {
    case Call::micromap_pack:
      for (std::uint8_t& state : as) state = static_cast<std::uint8_t>(state & ((1u << format) - 1));
      break;
    case Call::tree_encode:
      as.insert(as.end(), bytes.begin(), bytes.end());
      if (const std::uint32_t bits = format << 2 * level; level < 2 && bits < 8)
        as[0] = static_cast<std::uint8_t>(as[0] & ((1u << bits) - 1));
      break;
    case Call::micromap_unpack:
    case Call::micromap_up:
    case Call::micromap_down: as.insert(as.end(), bytes.begin(), bytes.end()); break;
    default: break;
  }
  return as;
}

/// Bytes of an element in a blob, and of its answer; 0 if the blob has no elements.
struct ElementsInBlob {
  std::size_t bytes, answer_bytes;
};
constexpr ElementsInBlob elements_in_blob(Call call) {
  return call == Call::attribute_face_mip ? ElementsInBlob{4 * bytes_of_face, bytes_of_face}
                                          : ElementsInBlob{0, 0};
}

}  // namespace mmverify::dock
