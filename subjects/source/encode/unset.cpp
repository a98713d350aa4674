#include "subjects/source/encode/unset.hpp"

namespace mmverify::source {
namespace {

/// The shadow; one without a set bit becomes a shadow of no bits.
Bits kept(Bits unset) {
  if (unset.value && *unset.value == 0) return {};
  return unset;
}
bool is_zero(const Bits& a) { return a.width == 0 || (a.value && *a.value == 0); }

Bits common(Definitions& d, const Bits& a, const Bits& b) {
  if (is_zero(a) || is_zero(b)) return {};
  return kept(d.binary("bvand", a, b));
}
Bits either_of(Definitions& d, const Bits& a, const Bits& b) {
  if (is_zero(a)) return kept(b);
  return is_zero(b) ? a : d.binary("bvor", a, b);
}
Bits inverse(Definitions& d, const Bits& a) {
  return a.value && a.width <= 64 ? constant(~*a.value, a.width) : d.unary("bvnot", a);
}

/// Sets all bits above the lowest set one: a bit of a sum depends on all bits below it.
Bits from_the_lowest(Definitions& d, const Bits& a) {
  if (is_zero(a)) return {};
  if (a.value) return constant(*a.value | (0 - *a.value), a.width);
  return d.binary("bvor", a, d.unary("bvneg", a));
}

}  // namespace

bool keeps_bits(Op op, std::size_t operand) {
  switch (op) {
    case Op::bit_and:
    case Op::bit_or:
    case Op::bit_xor:
    case Op::add:
    case Op::sub:
    case Op::mul:
    case Op::zext:
    case Op::sext:
    case Op::trunc:
    case Op::bswap:
    case Op::bitreverse:
    case Op::read: return true;
    case Op::shl:
    case Op::lshr:
    case Op::ashr: return operand == 0;
    case Op::fshl:
    case Op::fshr: return operand < 2;
    case Op::select: return operand > 0;
    default: return false;
  }
}

Bits turned(Definitions& d, Op op, const Bits& a) {
  const unsigned step = op == Op::bswap ? 8 : 1;
  Bits all;
  for (unsigned k = 0; k < a.width; k += step) all = d.concat(all, d.extract(a, k + step - 1, k));
  return all;
}

Bits funnelled(Definitions& d, Op op, const Bits& a, const Bits& b, const Bits& by) {
  const unsigned bits = a.width;
  const Bits both = d.concat(a, b);
  const Bits steps = d.widened(d.binary("bvurem", by, constant(bits, bits)), 2 * bits);
  if (op == Op::fshl) return d.extract(d.binary("bvshl", both, steps), 2 * bits - 1, bits);
  return d.extract(d.binary("bvlshr", both, steps), bits - 1, 0);
}

Bits shadow_of(Definitions& d, const Node& node, const std::vector<Shadowed>& of) {
  bool any = false;
  for (std::size_t k = 0; k < of.size(); ++k) any = any || (keeps_bits(node.op, k) && !is_zero(of[k].unset));
  if (!any) return {};
  const auto unset = [&](std::size_t k) -> const Bits& { return of[k].unset; };
  const auto full = [&](std::size_t k) { return is_zero(unset(k)) ? zeros(of[k].word.width) : unset(k); };
  switch (node.op) {
    case Op::read: return unset(0);
    case Op::bit_and:
    case Op::bit_or: {
      // A bit that was set, to 0 for `and` or to 1 for `or`, decides the result and hides the other bit.
      const auto shows = [&](std::size_t k) {
        return node.op == Op::bit_and ? of[k].word : inverse(d, of[k].word);
      };
      const Bits both = common(d, unset(0), unset(1));
      return either_of(d, both, either_of(d, common(d, unset(0), shows(1)), common(d, shows(0), unset(1))));
    }
    case Op::bit_xor: return either_of(d, unset(0), unset(1));
    case Op::add:
    case Op::sub:
    case Op::mul: return from_the_lowest(d, either_of(d, unset(0), unset(1)));
    case Op::zext: return kept(d.widened(unset(0), node.type.bits));
    case Op::sext: return kept(d.widened_with_sign(unset(0), node.type.bits));
    case Op::trunc: return kept(d.lowest(unset(0), node.type.bits));
    case Op::bswap:
    case Op::bitreverse: return turned(d, node.op, unset(0));
    case Op::shl: return kept(d.binary("bvshl", unset(0), of[1].word));
    case Op::lshr: return kept(d.binary("bvlshr", unset(0), of[1].word));
    case Op::ashr: return kept(d.binary("bvashr", unset(0), of[1].word));
    case Op::fshl:
    case Op::fshr: return kept(funnelled(d, node.op, full(0), full(1), of[2].word));
    default: return {};
  }
}

Bits with_free_bits(Definitions& d, const Shadowed& of, const Bits& free) {
  if (is_zero(of.unset)) return of.word;
  if (of.unset.value && of.unset.value == ones(of.unset.width).value) return free;
  return d.binary("bvor", d.binary("bvand", free, of.unset),
                  d.binary("bvand", of.word, inverse(d, of.unset)));
}

Condition any_unset(Definitions& d, const Bits& unset) {
  return is_zero(unset) ? "false" : negated(d.is_zero(unset));
}
Condition all_unset(Definitions& d, const Bits& unset) {
  return is_zero(unset) ? "false" : d.equal(unset, ones(unset.width));
}

}  // namespace mmverify::source
