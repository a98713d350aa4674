#include "subjects/source/reader/intrinsics.hpp"

#include <map>

namespace mmverify::source {

std::optional<std::pair<Op, unsigned>> plain_intrinsic(llvm::Intrinsic::ID id) {
  static const std::map<llvm::Intrinsic::ID, std::pair<Op, unsigned>> known{
      {llvm::Intrinsic::fabs, {Op::fabs, 1}},
      {llvm::Intrinsic::floor, {Op::floor, 1}},
      {llvm::Intrinsic::ceil, {Op::ceil, 1}},
      {llvm::Intrinsic::trunc, {Op::ftrunc, 1}},
      {llvm::Intrinsic::round, {Op::round, 1}},
      {llvm::Intrinsic::roundeven, {Op::roundeven, 1}},
      {llvm::Intrinsic::rint, {Op::roundeven, 1}},
      {llvm::Intrinsic::nearbyint, {Op::roundeven, 1}},
      {llvm::Intrinsic::fma, {Op::fma, 3}},
      {llvm::Intrinsic::copysign, {Op::copysign, 2}},
      {llvm::Intrinsic::minnum, {Op::fmin, 2}},
      {llvm::Intrinsic::maxnum, {Op::fmax, 2}},
      {llvm::Intrinsic::ctpop, {Op::ctpop, 1}},
      {llvm::Intrinsic::bswap, {Op::bswap, 1}},
      {llvm::Intrinsic::bitreverse, {Op::bitreverse, 1}},
      {llvm::Intrinsic::fshl, {Op::fshl, 3}},
      {llvm::Intrinsic::fshr, {Op::fshr, 3}},
      {llvm::Intrinsic::umin, {Op::umin, 2}},
      {llvm::Intrinsic::umax, {Op::umax, 2}},
      {llvm::Intrinsic::smin, {Op::smin, 2}},
      {llvm::Intrinsic::smax, {Op::smax, 2}},
      {llvm::Intrinsic::uadd_sat, {Op::uadd_sat, 2}},
      {llvm::Intrinsic::usub_sat, {Op::usub_sat, 2}},
      {llvm::Intrinsic::sadd_sat, {Op::sadd_sat, 2}},
      {llvm::Intrinsic::ssub_sat, {Op::ssub_sat, 2}},
      {llvm::Intrinsic::fptoui_sat, {Op::fptoui_sat, 1}},
      {llvm::Intrinsic::fptosi_sat, {Op::fptosi_sat, 1}}};
  const auto found = known.find(id);
  if (found == known.end()) return std::nullopt;
  return found->second;
}

}  // namespace mmverify::source
