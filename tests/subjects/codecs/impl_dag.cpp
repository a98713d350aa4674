// The library's own container of a scene's graph as a subject: its sources, word for word, in one file, as they are for
// processors without vectors.  Strings' functions have bodies here: the texts of its errors are made of them.
#define _GLIBCXX_EXTERN_TEMPLATE 0
#define HWY_COMPILE_ONLY_SCALAR
#include "impl/dag/build.cpp"
#include "impl/dag/container.cpp"
#include "impl/dag/lookup.cpp"
#include "impl/dag/walk.cpp"
#include "subjects/sdk/mmverify_subject.h"

namespace {

using namespace mmverify::impl::dag;

size_t put(const Dag& dag, uint8_t* scene, size_t capacity) {
  std::vector<std::uint8_t> bytes;
  for (std::uint32_t k = 0; k < dag.maps(); ++k) {
    bytes.push_back(static_cast<std::uint8_t>(dag.level(k)));
    const std::size_t first = bytes.size();
    bytes.resize(first + map_bytes(dag.level(k), static_cast<std::uint32_t>(dag.format())));
    dag.decode(k, std::span(bytes).subspan(first));
  }
  if (!bytes.empty() && bytes.size() <= capacity) std::memcpy(scene, bytes.data(), bytes.size());
  return bytes.size();
}

size_t decode(uint32_t format, const uint8_t* code, size_t size, uint8_t* scene, size_t capacity) {
  try {
    const Dag dag = load({code, size});
    return static_cast<std::uint32_t>(dag.format()) == format ? put(dag, scene, capacity) : 0;
  } catch (const BadContainer&) {
    return 0;
  }
}

}  // namespace

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  static mmverify_subject_t subject;
  subject.abi = MMVERIFY_SUBJECT_ABI;
  subject.size = sizeof subject;
  subject.name = "mmverify's own graph";
  subject.max_level = 12;
  subject.flags = MMVERIFY_DAG_CONTAINER;
  subject.dag_decode = decode;
  return &subject;
}
