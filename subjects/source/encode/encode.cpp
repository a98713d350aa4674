#include "subjects/source/encode/encode.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <set>

#include "subjects/source/encode/causes.hpp"
#include "subjects/source/encode/number.hpp"
#include "subjects/source/encode/unset.hpp"

namespace mmverify::source {
namespace {

/// The value of a node: a condition if it has one bit, else a word or a number.
struct Value {
  Condition condition = "false";
  Bits word = {};
  std::uint64_t most = 0;  ///< an upper bound on the word, unless it is poison
  Number number = {format_of(32)};
  Condition poison = "false";  ///< true if the value must not be used
  Bits unset = {};             ///< bits of the word that were never set (unset.hpp)
};

std::uint64_t mask(unsigned bits) { return bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1; }
std::uint64_t mask_of(std::uint64_t most) { return mask(static_cast<unsigned>(std::bit_width(most))); }

class Encoder {
 public:
  Encoder(const Program& program, const Exponents& u, const Exponents& v, const std::string& u_bits,
          const std::string& v_bits, Mistake mistake)
      : program_(program), u_(u), v_(v), u_bits_{u_bits, 32}, v_bits_{v_bits, 32}, d_numbers(d, mistake) {}

  Formula run() {
    values_.reserve(program_.nodes.size());
    for (const Node& node : program_.nodes) {
      // An operand's poison is inherited; a select inherits it only from the operand that it chooses.
      own_poison_ = "false";
      Value value = value_of(node);
      value.unset = unset_of(node);
      own_poison_ = d.name(own_poison_);
      own_.push_back(own_poison_);
      value.poison = d.name(either(inherited(node), own_poison_));
      if (value.unset.width == 1) {
        value.poison = d.name(either(value.poison, d.bit(value.unset, 0)));
        value.unset = {};
      }
      values_.push_back(std::move(value));
    }
    Formula formula;
    Condition undefined = must_not_be_used(values_[program_.result]);
    find_causes(program_.result);
    for (const Forbidden& f : program_.forbidden) {
      const Condition hit = d.name(either(values_[f.node].condition, values_[f.node].poison));
      if (hit == "false") continue;
      formula.causes.push_back({hit, f.what});
      undefined = either(undefined, hit);
      find_causes(f.node);
    }
    for (const auto* some : {&causes_, &open_causes_, &last_causes_})
      for (const auto& [node, cause] : *some) formula.causes.push_back(cause);
    formula.index = values_[program_.result].word.text;
    formula.undefined = d.name(undefined);
    formula.declarations = d.declarations();
    formula.definitions = d.all();
    return formula;
  }

 private:
  const Value& of(const Node& node, std::size_t k) const { return values_[node.of[k]]; }

  Condition must_not_be_used(const Value& v) { return d.name(either(v.poison, any_unset(d, v.unset))); }

  /// Collects the causes why the value of node `root` must not be used.
  void find_causes(std::uint32_t root) {
    std::vector<std::uint32_t> next{root};
    while (!next.empty()) {
      const std::uint32_t k = next.back();
      next.pop_back();
      if (!looked_at_.insert(k).second) continue;
      const Node& node = program_.nodes[k];
      const bool asks = node.op == Op::poisoned;
      if (!asks && values_[k].poison == "false" && values_[k].unset.width == 0) continue;
      const std::string where = said(node);
      if (node.op == Op::unset)
        last_causes_.emplace(k, Cause{"true", where});
      else if (own_[k] != "false")
        causes_.emplace(k, Cause{own_[k], where});
      if (node.op == Op::freeze) continue;
      for (std::size_t j = 0; j < node.of.size(); ++j) {
        const Node& from = program_.nodes[node.of[j]];
        // A select of a value that is left open introduces it: the cause is reported at the select.
        if (node.op == Op::select && j > 0 && from.op == Op::unset) {
          Node open = from;
          if (!node.where.empty()) open.where = node.where;
          const Condition& c = of(node, 0).condition;
          open_causes_.emplace(k, Cause{d.name(j == 1 ? c : choose(c, "false", "true")), said(open)});
        }
        next.push_back(node.of[j]);
      }
    }
  }

  Bits unset_of(const Node& node) {
    if (node.type.floating) return {};
    const unsigned bits = node.type.bits;
    if (node.op == Op::unset) return ones(bits);
    const auto full = [&](std::size_t k) {
      return of(node, k).unset.width == 0 ? zeros(bits) : of(node, k).unset;
    };
    if (node.op == Op::select) {
      if (of(node, 1).unset.width == 0 && of(node, 2).unset.width == 0) return {};
      return d.choose_word(of(node, 0).condition, full(1), full(2));
    }
    std::vector<Shadowed> operands;
    for (std::size_t k = 0; k < node.of.size(); ++k)
      operands.push_back({of(node, k).word, of(node, k).unset});
    if (node.op == Op::read) poison_where(all_unset(d, of(node, 0).unset));
    const Bits unset = shadow_of(d, node, operands);
    // The shadow is bit by bit, but a word without a set bit must not be used at all: C leaves x & 0
    // undefined.
    if ((node.op == Op::bit_and || node.op == Op::bit_or) && unset.width == 0)
      for (const std::size_t k : {0u, 1u}) poison_where(all_unset(d, of(node, k).unset));
    return unset;
  }

  Condition inherited(const Node& node) {
    if (node.op == Op::freeze || node.op == Op::poisoned) return "false";
    if (node.op == Op::select)
      return either(of(node, 0).poison,
                    choose(of(node, 0).condition, of(node, 1).poison, of(node, 2).poison));
    Condition any = "false";
    for (std::size_t k = 0; k < node.of.size(); ++k)
      any = either(any, keeps_bits(node.op, k) ? of(node, k).poison : must_not_be_used(of(node, k)));
    return any;
  }

  Value is(Condition c) {
    Value v;
    v.condition = d.name(c);
    v.most = 1;
    return v;
  }
  Value is(const Bits& word, std::uint64_t most) {
    if (word.width == 1) return is(d.bit(word, 0));
    Value v;
    v.word = word;
    v.most = word.value ? *word.value : std::min(most, mask(word.width));
    return v;
  }
  static Value is(Number x) {
    Value v;
    v.number = std::move(x);
    return v;
  }
  /// The value as a word, conditions included.
  Bits word(const Value& v, unsigned bits) { return bits == 1 ? d.of_condition(v.condition, 1) : v.word; }
  Bits word(const Node& node, std::size_t k) {
    return word(of(node, k), program_.nodes[node.of[k]].type.bits);
  }
  void poison_where(const Condition& c) { own_poison_ = either(own_poison_, c); }

  [[noreturn]] static void not_encoded(const Node& node, const std::string& why) {
    throw NotEncoded((node.where.empty() ? "" : node.where + ": ") + std::string(to_string(node.op)) + ": " +
                     why);
  }

  Value value_of(const Node& node) {
    if (node.op == Op::select) return selected(node);
    if (node.type.floating || node.op == Op::fcmp) return number_value(node);
    if (!node.of.empty() && program_.nodes[node.of[0]].type.floating) return from_number(node);
    return word_value(node);
  }

  Value selected(const Node& node) {
    const Value &a = of(node, 1), &b = of(node, 2);
    const Condition& c = of(node, 0).condition;
    if (node.type.floating) return is(d_numbers.chosen(c, a.number, b.number));
    if (node.type.bits == 1) return is(choose(c, a.condition, b.condition));
    return is(d.choose_word(c, a.word, b.word), c == "true"    ? a.most
                                                : c == "false" ? b.most
                                                               : std::max(a.most, b.most));
  }

  Value number_value(const Node& node) {
    Numbers& n = d_numbers;
    const auto x = [&](std::size_t k) -> const Number& { return of(node, k).number; };
    const Format format = format_of(node.type.bits == 64 ? 64 : 32);
    switch (node.op) {
      case Op::input_u: return is(n.of_bits(u_bits_, u_.negative, u_.first, u_.last));
      case Op::input_v: return is(n.of_bits(v_bits_, v_.negative, v_.first, v_.last));
      case Op::constant: return is(n.of_constant(node.numbers[0], node.type.bits));
      case Op::unset: poison_where("true"); return is(n.of_constant(0, node.type.bits));
      case Op::table: return is(n.of_bits(looked_up(node)));
      case Op::read:
      case Op::freeze:
        if (node.op == Op::read || of(node, 0).poison == "false") return of(node, 0);
        return is(n.chosen(of(node, 0).poison, n.of_bits(d.free_word(node.type.bits)), x(0)));
      case Op::float_of: return is(n.of_bits(word(node, 0)));
      case Op::fadd: return is(n.sum(x(0), x(1)));
      case Op::fsub: return is(n.sum(x(0), n.negative_of(x(1))));
      case Op::fmul: return is(n.product(x(0), x(1)));
      case Op::fdiv:
        if (auto q = n.quotient(x(0), x(1))) return is(*q);
        not_encoded(node, "by what is no power of two");
      case Op::fma: return is(n.fused(x(0), x(1), x(2)));
      case Op::fneg: return is(n.negative_of(x(0)));
      case Op::fabs: return is(n.size_of(x(0)));
      case Op::copysign: return is(n.with_sign_of(x(0), x(1)));
      case Op::fmin:
      case Op::fmax: return is(n.lesser(x(0), x(1), node.op == Op::fmax));
      case Op::floor:
      case Op::ceil:
      case Op::ftrunc:
      case Op::round:
      case Op::roundeven: return is(n.whole(node.op, x(0)));
      case Op::uitofp:
      case Op::sitofp: return is(n.of_word(word(node, 0), of(node, 0).most, node.op == Op::sitofp, format));
      case Op::fpext:
      case Op::fptrunc: return is(n.converted(x(0), format));
      case Op::fcmp: return is(n.compared(static_cast<unsigned>(node.numbers[0]), x(0), x(1)));
      default: not_encoded(node, "no such number");
    }
  }

  Value from_number(const Node& node) {
    const Number& x = of(node, 0).number;
    const unsigned bits = node.type.bits;
    switch (node.op) {
      case Op::poisoned: return is(must_not_be_used(of(node, 0)));
      case Op::bits_of: return is(d_numbers.to_bits(x), mask(bits));
      case Op::fptoui:
      case Op::fptosi: {
        const Numbers::Word w = d_numbers.to_word(x, bits, node.op == Op::fptosi);
        poison_where(negated(w.fits));
        return is(w.word, w.most);
      }
      case Op::fptoui_sat:
      case Op::fptosi_sat:
        return is(d_numbers.to_word_saturated(x, bits, node.op == Op::fptosi_sat), mask(bits));
      default: not_encoded(node, "no such word");
    }
  }

  Value word_value(const Node& node) {
    const unsigned bits = node.type.bits;
    switch (node.op) {
      case Op::constant: return is(constant(node.numbers[0], bits), node.numbers[0]);
      case Op::unset: return is(zeros(bits), 0);
      case Op::table:
        return is(looked_up(node), *std::max_element(node.numbers.begin() + 1, node.numbers.end()));
      case Op::read: return of(node, 0);
      case Op::freeze: {
        const Condition open = must_not_be_used(of(node, 0));
        if (open == "false") return of(node, 0);
        const Bits free = d.free_word(bits),
                   some = with_free_bits(d, {word(node, 0), of(node, 0).unset}, free);
        return is(d.choose_word(of(node, 0).poison, free, some), mask(bits));
      }
      case Op::poisoned: return is(must_not_be_used(of(node, 0)));
      case Op::zext: return is(d.widened(word(node, 0), bits), of(node, 0).most);
      case Op::sext: {
        const unsigned from = program_.nodes[node.of[0]].type.bits;
        const std::uint64_t most = of(node, 0).most;
        return is(d.widened_with_sign(word(node, 0), bits),
                  most < std::uint64_t{1} << (from - 1) ? most : mask(bits));
      }
      case Op::trunc: return is(d.lowest(word(node, 0), bits), std::min(of(node, 0).most, mask(bits)));
      case Op::ctpop:
      case Op::ctlz:
      case Op::cttz:
      case Op::bswap:
      case Op::bitreverse:
      case Op::abs: return one_word(node);
      case Op::fshl:
      case Op::fshr:
        if (!std::has_single_bit(bits)) not_encoded(node, "of words of another size than a power of two");
        return is(funnelled(d, node.op, word(node, 0), word(node, 1), word(node, 2)), mask(bits));
      case Op::eq: return is(d.equal(word(node, 0), word(node, 1)));
      case Op::ne: return is(negated(d.equal(word(node, 0), word(node, 1))));
      case Op::ult: return is(d.below(word(node, 0), word(node, 1)));
      case Op::ule: return is(negated(d.below(word(node, 1), word(node, 0))));
      case Op::slt: return is(d.asked("bvslt", word(node, 0), word(node, 1)));
      case Op::sle: return is(d.asked("bvsle", word(node, 0), word(node, 1)));
      default: return two_words(node);
    }
  }

  /// The table's element at a byte offset, chosen by the bits of its index. An offset outside the table or
  /// between elements is poison.
  Bits looked_up(const Node& node) {
    const std::uint64_t size = node.numbers[0], count = node.numbers.size() - 1;
    const Bits offset = word(node, 0);
    const Bits place = size == 1 ? offset : d.binary("bvudiv", offset, constant(size, 64));
    if (size != 1) poison_where(negated(d.is_zero(d.binary("bvurem", offset, constant(size, 64)))));
    if (of(node, 0).most >= size * count) poison_where(negated(d.below(place, constant(count, 64))));
    const auto part = [&](const auto& self, std::uint64_t first, unsigned bit) -> Bits {
      if (first >= count) return zeros(node.type.bits);
      if (bit == 0) return constant(node.numbers[1 + first], node.type.bits);
      const Bits low = self(self, first, bit - 1),
                 high = self(self, first + (std::uint64_t{1} << (bit - 1)), bit - 1);
      return d.choose_word(d.bit(place, bit - 1), high, low);
    };
    return part(part, 0, static_cast<unsigned>(std::bit_width(count - 1)));
  }

  Value one_word(const Node& node) {
    const unsigned bits = node.type.bits;
    const Bits a = word(node, 0);
    const auto number_of = [&](auto at) {
      // The number of the first set bit, counted from one end.
      Bits count = constant(bits, bits);
      for (unsigned k = bits; k-- > 0;) count = d.choose_word(d.bit(a, at(k)), constant(k, bits), count);
      return count;
    };
    switch (node.op) {
      case Op::ctlz:
      case Op::cttz: {
        if (bits < 3) not_encoded(node, "of a word of so few bits");
        if (node.flags & defined_at_all_but_zero) poison_where(d.is_zero(a));
        const bool leading = node.op == Op::ctlz;
        return is(number_of([&](unsigned k) { return leading ? bits - 1 - k : k; }), bits);
      }
      case Op::ctpop: {
        Bits sum = zeros(bits);
        for (unsigned k = 0; k < bits; ++k) sum = d.binary("bvadd", sum, d.widened(d.extract(a, k, k), bits));
        return is(sum, mask(bits));
      }
      case Op::bswap:
      case Op::bitreverse: return is(turned(d, node.op, a), mask(bits));
      default: {
        const Condition negative = d.bit(a, bits - 1);
        if (node.flags & defined_at_all_but_zero)
          poison_where(d.equal(a, d.concat(constant(1, 1), zeros(bits - 1))));
        return is(d.choose_word(negative, d.unary("bvneg", a), a), mask(bits));
      }
    }
  }

  /// The operands of an operation on two words.
  struct Operands {
    unsigned bits;
    Bits a, b;
    std::uint64_t most_a, most_b;
  };

  /// Whether the exact result differs from the one of as many bits as the operands have.
  Condition wraps(const char* head, const Operands& of, const Bits& result, bool with_sign) {
    const unsigned bits = of.bits, width = head == std::string_view("bvmul") ? 2 * bits : bits + 1;
    const auto widen = [&](const Bits& w) {
      return with_sign ? d.widened_with_sign(w, width) : d.widened(w, width);
    };
    return negated(d.equal(d.binary(head, widen(of.a), widen(of.b)), widen(result)));
  }

  Value arithmetic(const Node& node, const char* head, const Operands& of, std::uint64_t most) {
    const Bits result = d.binary(head, of.a, of.b);
    if (node.flags & no_unsigned_wrap) poison_where(wraps(head, of, result, false));
    if (node.flags & no_signed_wrap) poison_where(wraps(head, of, result, true));
    return is(result, most);
  }

  Value saturated(const char* head, const Operands& of, bool with_sign) {
    const unsigned bits = of.bits;
    const std::uint64_t all = mask(bits);
    const Bits result = d.binary(head, of.a, of.b);
    const Condition over = wraps(head, of, result, with_sign);
    if (!with_sign) return is(d.choose_word(over, head[2] == 'a' ? ones(bits) : zeros(bits), result), all);
    const Bits least = d.concat(constant(1, 1), zeros(bits - 1)), most = d.concat(zeros(1), ones(bits - 1));
    return is(d.choose_word(over, d.choose_word(d.bit(of.a, bits - 1), least, most), result), all);
  }

  Value quotient(const Node& node, const Operands& of) {
    const auto& [bits, a, b, most_a, most_b] = of;
    const Bits q = d.binary(node.op == Op::udiv ? "bvudiv" : "bvsdiv", a, b);
    if (node.flags & exact) poison_where(negated(d.equal(d.binary("bvmul", q, b), a)));
    // Division by zero gives all ones.
    return is(q, node.op == Op::udiv && b.value && *b.value != 0 ? most_a / *b.value : mask(bits));
  }

  Value shifted(const Node& node, const Operands& of) {
    const auto& [bits, a, b, most_a, most_b] = of;
    const std::uint64_t all = mask(bits);
    const bool nuw = node.flags & no_unsigned_wrap, nsw = node.flags & no_signed_wrap,
               whole = node.flags & exact;
    if (most_b >= bits) poison_where(negated(d.below(b, constant(bits, bits))));
    const bool up = node.op == Op::shl;
    const char* back = up && nsw && !nuw ? "bvashr" : up ? "bvlshr" : "bvshl";
    const Bits result = d.binary(up ? "bvshl" : node.op == Op::lshr ? "bvlshr" : "bvashr", a, b);
    const auto returns = [&, by = b, before = a](const char* head) {
      return d.equal(d.binary(head, result, by), before);
    };
    if (up && nuw) poison_where(negated(returns("bvlshr")));
    if (up && nsw) poison_where(negated(returns("bvashr")));
    if (!up && whole) poison_where(negated(returns(back)));
    if (up) {
      const bool fits = b.value && *b.value < bits && most_a <= all >> *b.value;
      return is(result, fits ? most_a << *b.value : all);
    }
    const bool down = node.op == Op::lshr;
    return is(result, !down ? all : b.value && *b.value < bits ? most_a >> *b.value : most_a);
  }

  Value two_words(const Node& node) {
    const unsigned bits = node.type.bits;
    const Operands of_both{bits, word(node, 0), word(node, 1), of(node, 0).most, of(node, 1).most};
    const Bits &a = of_both.a, &b = of_both.b;
    const std::uint64_t most_a = of_both.most_a, most_b = of_both.most_b;
    const std::uint64_t all = mask(bits);
    const auto chosen = [&](const Condition& first, std::uint64_t most) {
      return is(d.choose_word(first, a, b), most);
    };
    switch (node.op) {
      case Op::add: {
        const bool fits = most_a <= all - most_b;
        return arithmetic(node, "bvadd", of_both, fits ? most_a + most_b : all);
      }
      case Op::sub: return arithmetic(node, "bvsub", of_both, all);
      case Op::mul: {
        const bool fits = most_b == 0 || most_a <= all / most_b;
        return arithmetic(node, "bvmul", of_both, fits ? most_a * most_b : all);
      }
      case Op::udiv:
      case Op::sdiv: return quotient(node, of_both);
      case Op::urem: return is(d.binary("bvurem", a, b), most_a);
      case Op::srem: return is(d.binary("bvsrem", a, b), all);
      case Op::shl:
      case Op::lshr:
      case Op::ashr: return shifted(node, of_both);
      case Op::bit_and:
        return bits == 1 ? is(both(of(node, 0).condition, of(node, 1).condition))
                         : is(d.binary("bvand", a, b), std::min(most_a, most_b));
      case Op::bit_or:
        return bits == 1 ? is(either(of(node, 0).condition, of(node, 1).condition))
                         : is(d.binary("bvor", a, b), mask_of(most_a | most_b));
      case Op::bit_xor:
        return bits == 1 ? is(differ(of(node, 0).condition, of(node, 1).condition))
                         : is(d.binary("bvxor", a, b), mask_of(most_a | most_b));
      case Op::umin: return chosen(d.below(a, b), std::min(most_a, most_b));
      case Op::umax: return chosen(d.below(b, a), std::max(most_a, most_b));
      case Op::smin: return chosen(d.asked("bvslt", a, b), all);
      case Op::smax: return chosen(d.asked("bvslt", b, a), all);
      case Op::uadd_sat: return saturated("bvadd", of_both, false);
      case Op::usub_sat: return saturated("bvsub", of_both, false);
      case Op::sadd_sat: return saturated("bvadd", of_both, true);
      case Op::ssub_sat: return saturated("bvsub", of_both, true);
      default: not_encoded(node, "no such word");
    }
  }

  const Program& program_;
  Exponents u_, v_;
  Bits u_bits_, v_bits_;
  Definitions d{"code_"};
  Numbers d_numbers;
  std::vector<Value> values_;
  /// The causes by node; last_causes_ serve only if no other cause holds.
  std::multimap<std::uint32_t, Cause> causes_, open_causes_, last_causes_;
  Condition own_poison_ = "false";
  std::vector<Condition> own_;  ///< of each node: whether the node itself makes poison
  std::set<std::uint32_t> looked_at_;
};

}  // namespace

Formula encode(const Program& program, const Exponents& u, const Exponents& v, const std::string& u_bits,
               const std::string& v_bits, Mistake mistake) {
  return Encoder(program, u, v, u_bits, v_bits, mistake).run();
}

}  // namespace mmverify::source
