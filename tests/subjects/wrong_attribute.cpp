// The example of attribute maps but for one thing, chosen when it is linked.
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

#include "subjects/sdk/mmverify_subject.h"
#include "tests/subjects/wrong.hpp"

extern "C" const mmverify_subject_t* right_attribute(void);

namespace {

using Word = std::uint32_t;

volatile int* volatile nowhere = nullptr;

void vertex_index(Word level, Word order, const Word* i, const Word* j, Word* index, std::size_t count) {
  Word asked = order;
  // The order of the first call, for all that come.
  if (wrong_is("order_of_before")) {
    static const Word first = order;
    asked = first;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const bool here = level == 4 && i[k] == 3 && j[k] == 5;
    if (here && wrong_is("crash")) *nowhere = 1;
    if (here && order == MMVERIFY_VERTICES_BIRD && wrong_is("unwritten")) continue;
    right_attribute()->attribute_vertex_index(level, asked, i + k, j + k, index + k, 1);
    // One of level 7's vertices, five levels further down.
    const bool far = level == 12 && order == MMVERIFY_VERTICES_BIRD && index[k] == 8000;
    if (far && wrong_is("bird_vertex_at_12")) ++index[k];
    if (!here) continue;
    if (wrong_is("bird_vertex_twice") && order == MMVERIFY_VERTICES_BIRD) index[k] ^= 1;
    if (wrong_is("index_beyond")) index[k] = ~0u;
  }
}

void vertex_place(Word level, Word order, const Word* index, Word* place, std::size_t count) {
  right_attribute()->attribute_vertex_place(level, order, index, place, count);
  if (!wrong_is("w_minor_row_turned") || order != MMVERIFY_VERTICES_W_MINOR) return;
  for (std::size_t k = 0; k < count; ++k)
    if (place[2 * k] + place[2 * k + 1] == 7) {
      const Word i = place[2 * k];
      place[2 * k] = place[2 * k + 1];
      place[2 * k + 1] = i;
    }
}

void face_index(Word level, Word order, const Word* iu, const Word* iv, const Word* upper, Word* index,
                std::size_t count) {
  const bool rows = wrong_is("curve_as_rows") && order == MMVERIFY_FACES_CURVE && level >= 3;
  right_attribute()->attribute_face_index(level, rows ? MMVERIFY_FACES_ROWS : order, iu, iv, upper, index,
                                          count);
}

void face_place(Word level, Word order, const Word* index, Word* place, std::size_t count) {
  right_attribute()->attribute_face_place(level, order, index, place, count);
  if (!wrong_is("half_is_2")) return;
  for (std::size_t k = 0; k < count; ++k)
    if (level == 5 && place[3 * k + 2] == 1 && place[3 * k] == 7) place[3 * k + 2] = 2;
}

void triplet(Word level, Word vertices, Word faces, const Word* face, Word* out, std::size_t count) {
  right_attribute()->attribute_triplet(level, vertices, faces, face, out, count);
  if (!wrong_is("figure_4_cycle")) return;
  for (std::size_t k = 0; k < count; ++k) {
    Word place[3];
    right_attribute()->attribute_face_place(level, faces, face + k, place, 1);
    if (place[2] == 0) continue;
    const Word last = out[3 * k + 2];
    out[3 * k + 2] = out[3 * k + 1];
    out[3 * k + 1] = out[3 * k];
    out[3 * k] = last;
  }
}

void face_of(Word level, Word vertices, Word faces, const Word* first, const Word* second, const Word* third,
             Word* face, std::size_t count) {
  right_attribute()->attribute_face_of(level, vertices, faces, first, second, third, face, count);
  if (wrong_is("lower_for_upper") && faces == MMVERIFY_FACES_U_MAJOR)
    for (std::size_t k = 0; k < count; ++k)
      if (level == 3 && face[k] == 20) face[k] = 19;
  if (!wrong_is("vertex_without_level")) return;
  // The first vertex's place, cached by its index and order but not its level.
  thread_local struct { Word index = ~0u, order = 0, place[2] = {}; } kept;
  for (std::size_t k = 0; k < count; ++k) {
    Word place[2];
    right_attribute()->attribute_vertex_place(level, vertices, first + k, place, 1);
    if (kept.index == first[k] && kept.order == vertices) {
      if (std::memcmp(kept.place, place, sizeof place) != 0) face[k] ^= 1;
      continue;
    }
    kept.index = first[k];
    kept.order = vertices;
    std::memcpy(kept.place, place, sizeof place);
  }
}

void triplet_f32(Word level, Word order, const float* u, const float* v, Word* out, std::size_t count) {
  right_attribute()->attribute_triplet_f32(level, order, u, v, out, count);
  if (!wrong_is("rounded_carry")) return;
  for (std::size_t k = 0; k < count; ++k) {
    const auto side = static_cast<float>(1u << level);
    const float x = u[k] * side, y = v[k] * side;
    const auto iu = static_cast<Word>(x), iv = static_cast<Word>(y);
    if (iu + iv + 1 >= 1u << level) continue;
    const volatile float sum = (x - static_cast<float>(iu)) + (y - static_cast<float>(iv));
    const Word upper = sum >= 1 ? 1 : 0;
    Word face = 0;
    right_attribute()->attribute_face_index(level, MMVERIFY_FACES_ROWS, &iu, &iv, &upper, &face, 1);
    right_attribute()->attribute_triplet(level, order, MMVERIFY_FACES_ROWS, &face, out + 3 * k, 1);
  }
}

void weights_f32(Word level, const float* u, const float* v, float* out, std::size_t count) {
  right_attribute()->attribute_weights_f32(level, u, v, out, count);
  static volatile int calls = 0;
  calls = calls + 1;
  for (std::size_t k = 0; k < count; ++k) {
    const auto side = static_cast<float>(1u << level);
    const float x = u[k] * side, y = v[k] * side;
    const float fu = x - static_cast<float>(static_cast<Word>(x)),
                fv = y - static_cast<float>(static_cast<Word>(y));
    if (wrong_is("lower_weights_on_upper") && fu + fv > 1) {
      out[3 * k] = 1 - fu - fv;
      out[3 * k + 1] = fu;
      out[3 * k + 2] = fv;
    }
    if (wrong_is("weights_count_calls") && calls > 1) out[3 * k + 1] += 1;
  }
}

void decimate(Word level, Word flags, const Word* i, const Word* j, Word* place, std::size_t count) {
  right_attribute()->attribute_decimate(level, flags, i, j, place, count);
  if (!wrong_is("towards_the_middle")) return;
  for (std::size_t k = 0; k < count; ++k) {
    // To the other side of where it was.
    place[2 * k] = 2 * i[k] - place[2 * k];
    place[2 * k + 1] = 2 * j[k] - place[2 * k + 1];
  }
}

void face_mip(Word rounding, const std::uint8_t* children, std::size_t parents, std::uint8_t* out) {
  const bool up = wrong_is("halves_go_up") && rounding == MMVERIFY_ROUND_HALF_TO_EVEN;
  std::vector<std::uint8_t> read(children, children + 16 * parents);
  for (std::size_t p = 0; p < parents; ++p) {
    // The second child has its greatest code in all channels, or is black if it has no alpha.
    std::uint8_t* const second = &read[16 * p + 4];
    if (wrong_is("second_child_is_grey")) std::fill_n(second, 4, *std::max_element(second, second + 4));
    if (wrong_is("second_child_without_alpha_is_black") && second[3] == 0)
      std::fill_n(second, 4, std::uint8_t{0});
  }
  right_attribute()->attribute_face_mip(up ? MMVERIFY_ROUND_HALF_UP : rounding, read.data(), parents, out);
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject = *right_attribute();
  subject.name = "wrong attribute maps";
  subject.attribute_vertex_index = vertex_index;
  subject.attribute_vertex_place = vertex_place;
  subject.attribute_face_index = face_index;
  subject.attribute_face_place = face_place;
  subject.attribute_triplet = triplet;
  subject.attribute_face_of = face_of;
  subject.attribute_triplet_f32 = triplet_f32;
  subject.attribute_weights_f32 = weights_f32;
  subject.attribute_decimate = decimate;
  subject.attribute_face_mip = face_mip;
  if (wrong_is("indices_only")) {
    subject.attribute_vertex_place = nullptr;
    subject.attribute_face_place = nullptr;
    subject.attribute_triplet = nullptr;
    subject.attribute_face_of = nullptr;
    subject.attribute_triplet_f32 = nullptr;
    subject.attribute_weights_f32 = nullptr;
    subject.attribute_decimate = nullptr;
    subject.attribute_face_mip = nullptr;
  }
  if (wrong_is("old_header")) {
    subject.size = offsetof(mmverify_subject_t, attribute_vertex_index);
    // The memory behind an older struct is somebody else's.
    std::memset(&subject.attribute_vertex_index, 0x77, sizeof subject - subject.size);
  }
  return &subject;
}
