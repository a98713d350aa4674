#include "subjects/source/encode/causes.hpp"

namespace mmverify::source {

std::string said(const Node& node) {
  const std::string at = node.where.empty() ? "" : ", " + node.where;
  switch (node.op) {
    case Op::unset:
    case Op::read:
    case Op::bit_and:
    case Op::bit_or: return "a value that was never set, or is left open" + at;
    case Op::shl:
    case Op::lshr:
    case Op::ashr: return std::string(to_string(node.op)) + ": a shift too far, or bits lost" + at;
    case Op::fptoui:
    case Op::fptosi: return std::string(to_string(node.op)) + ": a float beyond the integers it becomes" + at;
    case Op::ctlz:
    case Op::cttz: return std::string(to_string(node.op)) + ": of 0" + at;
    case Op::table: return "a read outside of a table" + at;
    default: return std::string(to_string(node.op)) + ": overflow that must not be" + at;
  }
}

}  // namespace mmverify::source
