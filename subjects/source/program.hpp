// A function of two floats at one level, as a program without loops, calls or memory: numbered operations on
// earlier ones.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mmverify::source {

/// An operation. Words are unsigned and wrap; signed operations say so. Semantics: LLVM's Language Reference,
/// the instruction or intrinsic of that name; floats follow IEEE 754, rounded to nearest, ties to even.
///   constant    numbers[0]: the value, or a float's bits
///   unset       a value that was never set, or is left open: it may be used if none of its bits matters
///   read        of[0], which must not be used if none of its bits is set
///   table       numbers: bytes of an element, then the elements; of[0]: a byte offset of 64 bits
///   fcmp        numbers[0]: 1 equal + 2 greater + 4 less + 8 unordered
///   poisoned    whether of[0], or any bit of it, must not be used
///   bits_of, float_of   a float's bits as a word, and back
enum class Op : std::uint8_t {
  input_u,
  input_v,
  constant,
  unset,
  add,
  sub,
  mul,
  udiv,
  urem,
  sdiv,
  srem,
  shl,
  lshr,
  ashr,
  bit_and,
  bit_or,
  bit_xor,
  eq,
  ne,
  ult,
  ule,
  slt,
  sle,
  select,
  zext,
  sext,
  trunc,
  ctpop,
  ctlz,
  cttz,
  bswap,
  bitreverse,
  fshl,
  fshr,
  abs,
  umin,
  umax,
  smin,
  smax,
  uadd_sat,
  usub_sat,
  sadd_sat,
  ssub_sat,
  read,
  freeze,
  poisoned,
  table,
  bits_of,
  float_of,
  fadd,
  fsub,
  fmul,
  fdiv,
  fma,
  fneg,
  fabs,
  copysign,
  fcmp,
  fmin,
  fmax,
  floor,
  ceil,
  ftrunc,
  round,
  roundeven,
  fptoui,
  fptosi,
  fptoui_sat,
  fptosi_sat,
  uitofp,
  sitofp,
  fpext,
  fptrunc,
};

/// The operation's name in a program's text.
std::string_view to_string(Op op);

/// Conditions on an operation: if it violates one, its value is poison.
enum Flag : unsigned {
  no_unsigned_wrap = 1,
  no_signed_wrap = 2,
  exact = 4,
  defined_at_all_but_zero = 8,  ///< ctlz, cttz: defined at all but 0; abs: at all but the least number
};

struct Type {
  bool floating = false;
  unsigned bits = 0;  ///< 1..64 for a word; 32 or 64 for a float
  friend bool operator==(const Type&, const Type&) = default;
};

struct Node {
  Op op = Op::unset;
  Type type;
  std::vector<std::uint32_t> of = {};  ///< numbers of earlier nodes, the operands
  std::vector<std::uint64_t> numbers = {};
  unsigned flags = 0;
  std::string where = {};  ///< "mine.c:12"; empty if unknown
};

/// An event that must not happen. It happens if the node, of one bit, is 1.
struct Forbidden {
  std::uint32_t node;
  std::string what;  ///< "division by zero, mine.c:12"
};

struct Program {
  std::vector<Node> nodes;
  std::vector<Forbidden> forbidden;
  std::uint32_t result = 0;  ///< a 32-bit node
};

/// A text that is no program; what() gives the fault and the line.
struct BadProgram : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A line for each node, `OP TYPE of... : numbers... ! flags @ where`, where the last three may be absent;
/// then `forbidden NODE WHAT` lines, and at the end `result NODE`.
std::string to_text(const Program& program);

/// The inverse of to_text. Every operand is an earlier node of the sort that the operation takes.
/// Throws BadProgram.
Program read_program(const std::string& text);

}  // namespace mmverify::source
