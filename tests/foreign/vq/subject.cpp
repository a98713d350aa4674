// Square opacity maps, VQ2 and VQ4, written from "Compressed Opacity Maps" and docs/VQ.md alone, with faults to choose from.
//
// Right unless MMVERIFY_FAULT names a row of vq_faults.def; then it is wrong in that one way.
#include "subjects/sdk/mmverify_subject.h"
#include "tests/foreign/vq/entry_points.hpp"
#include "tests/foreign/vq/faults.hpp"

namespace mmverify::tests::foreign::vq {
namespace {

mmverify_subject_t subject() {
  mmverify_subject_t s{};
  s.abi = MMVERIFY_SUBJECT_ABI;
  s.size = sizeof s;
  s.name = "a stranger's square maps";
  s.max_level = 12;
  s.flags = threading() | MMVERIFY_VQ_KEEPS;
  s.vq2_decode = vq2_decode;
  s.vq2_region = vq2_region;
  s.vq2_encode = vq2_encode;
  s.vq4_decode = vq4_decode;
  s.vq4_region = vq4_region;
  s.vq4_encode = vq4_encode;
  return s;
}

}  // namespace
}  // namespace mmverify::tests::foreign::vq

extern "C" const mmverify_subject_t* mmverify_subject_v1(void) {
  using namespace mmverify::tests::foreign::vq;
  static const mmverify_subject_t it = subject();
  return fault.has_value() ? &it : nullptr;
}
