#include "tests/independence/right.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "subjects/dock/entry_points.hpp"

extern "C" {
const mmverify_subject_t* right_batched(void);
const mmverify_subject_t* right_several(void);
const mmverify_subject_t* right_c_face(void);
const mmverify_subject_t* right_vq(void);
const mmverify_subject_t* right_attribute(void);
const mmverify_subject_t* right_attribute_bake(void);
const mmverify_subject_t* right_traverse(void);
const mmverify_subject_t* right_array(void);
const mmverify_subject_t* right_array_changes(void);
const mmverify_subject_t* right_dag(void);
const mmverify_subject_t* right_mesh(void);
const mmverify_subject_t* right_subdivision(void);
}

namespace mmverify::independence {
namespace {

using Function = void (*)();

Function& function_of(mmverify_subject_t& s, const dock::EntryPoint& e) {
  return *reinterpret_cast<Function*>(reinterpret_cast<std::byte*>(&s) + e.offset);
}

/// The example of a scene's maps looks up by index alone: the level of a map says which.
void dag_lookup_f32(std::uint32_t format, const std::uint8_t* code, std::size_t code_size,
                    const std::uint32_t* map, const float* u, const float* v, std::uint8_t* state,
                    std::size_t count) {
  std::vector<std::uint8_t> scene(right_dag()->dag_decode(format, code, code_size, nullptr, 0));
  right_dag()->dag_decode(format, code, code_size, scene.data(), scene.size());
  std::vector<std::uint32_t> levels;
  for (std::size_t at = 0; at < scene.size();) {
    levels.push_back(scene[at]);
    at += 1 + ((std::size_t{1} << 2 * scene[at]) * format + 7) / 8;
  }
  for (std::size_t k = 0; k < count; ++k) {
    std::uint32_t index = 0;
    right_batched()->index_f32(levels[map[k]], u + k, v + k, &index, 1);
    right_dag()->dag_lookup(format, code, code_size, map + k, &index, state + k, 1);
  }
}

}  // namespace

mmverify_subject_t right_of_all() {
  mmverify_subject_t all{};
  all.abi = MMVERIFY_SUBJECT_ABI;
  all.size = sizeof all;
  all.max_level = 16;
  for (const mmverify_subject_t* one :
       {right_batched(), right_several(), right_c_face(), right_vq(), right_attribute(),
        right_attribute_bake(), right_traverse(), right_array(), right_array_changes(), right_dag(),
        right_mesh(), right_subdivision()}) {
    mmverify_subject_t its{};
    std::memcpy(&its, one, one->size);
    for (const dock::EntryPoint& e : dock::entry_points)
      if (function_of(all, e) == nullptr) function_of(all, e) = function_of(its, e);
    all.flags |= its.flags & ~std::uint32_t{MMVERIFY_SINGLE_THREADED};
    if (its.attribute_support != nullptr) all.attribute_support = its.attribute_support;
  }
  all.dag_lookup_f32 = dag_lookup_f32;
  for (const dock::EntryPoint& e : dock::entry_points)
    if (function_of(all, e) == nullptr) throw std::logic_error(std::string("no right ") + e.name);
  return all;
}

}  // namespace mmverify::independence
