// A baker of opacity micromaps, written from the header, the design and the rules of Vulkan's samplers alone.
// It is exact: whole numbers decide whatever binary64 leaves open.  One fault at a time can be built in.
#include "subjects/sdk/mmverify_subject.h"
#include "tests/foreign/bake/baker.hpp"
#include "tests/foreign/bake/faults.hpp"
#include "tests/foreign/bake/kept.hpp"

namespace mmverify::tests::foreign::bake {
namespace {

const mmverify_subject_t subject = [] {
  mmverify_subject_t s{};
  s.abi = MMVERIFY_SUBJECT_ABI;
  s.size = sizeof(mmverify_subject_t);
  s.name = "foreign-bake";
  s.max_level = 12;
  s.flags = threading() | MMVERIFY_BAKE_CENTROID | MMVERIFY_BAKE_TIGHT;
  s.bake = [](const mmverify_bake_case_t* what, std::uint8_t* map) {
    const mmverify_bake_case_t c = with_kept_texels(*what);
    return bake(&c, map);
  };
  return s;
}();

}  // namespace
}  // namespace mmverify::tests::foreign::bake

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  using namespace mmverify::tests::foreign::bake;
  return fault ? &subject : nullptr;
}
