#include "subjects/source/encode/words.hpp"

#include <string_view>

namespace mmverify::source {
namespace {

std::string applied(const std::string& head, const std::string& a, const std::string& b = {}) {
  return "(" + head + " " + a + (b.empty() ? "" : " " + b) + ")";
}
std::string sort_of(unsigned width) { return "(_ BitVec " + std::to_string(width) + ")"; }
bool is_atom(const std::string& text) { return text.front() != '(' || text.starts_with("(_ bv"); }

/// The result of an operation on two constants; nothing if it is not folded. Fixing a level makes such
/// constants.
std::optional<std::uint64_t> folded(std::string_view head, std::uint64_t a, std::uint64_t b, unsigned width) {
  if (head == "bvadd") return a + b;
  if (head == "bvsub") return a - b;
  if (head == "bvmul") return a * b;
  if (head == "bvand") return a & b;
  if (head == "bvor") return a | b;
  if (head == "bvxor") return a ^ b;
  if (head == "bvshl") return b >= width ? 0 : a << b;
  if (head == "bvlshr") return b >= width ? 0 : a >> b;
  return std::nullopt;
}

}  // namespace

Condition both(const Condition& a, const Condition& b) {
  if (a == "false" || b == "false") return "false";
  if (a == "true" || a == b) return b;
  return b == "true" ? a : applied("and", a, b);
}
Condition either(const Condition& a, const Condition& b) {
  if (a == "true" || b == "true") return "true";
  if (a == "false" || a == b) return b;
  return b == "false" ? a : applied("or", a, b);
}
Condition negated(const Condition& a) {
  if (a == "true") return "false";
  return a == "false" ? "true" : applied("not", a);
}
Condition differ(const Condition& a, const Condition& b) {
  if (a == "false") return b;
  if (b == "false") return a;
  if (a == "true") return negated(b);
  if (b == "true") return negated(a);
  return a == b ? "false" : applied("xor", a, b);
}
Condition choose(const Condition& c, const Condition& a, const Condition& b) {
  if (c == "true" || a == b) return a;
  if (c == "false") return b;
  if (a == "true") return either(c, b);
  if (a == "false") return both(negated(c), b);
  if (b == "true") return either(negated(c), a);
  return b == "false" ? both(c, a) : "(ite " + c + " " + a + " " + b + ")";
}

Bits constant(std::uint64_t value, unsigned width) {
  if (width < 64) value &= (std::uint64_t{1} << width) - 1;
  return {"(_ bv" + std::to_string(value) + " " + std::to_string(width) + ")", width, value};
}
Bits zeros(unsigned width) { return constant(0, width); }
Bits ones(unsigned width) {
  if (width <= 64) return constant(~std::uint64_t{0}, width);
  return {applied("bvnot", zeros(width).text), width};
}

std::string Definitions::defined(const std::string& formula) {
  if (is_atom(formula)) return formula;
  const auto [place, is_new] = names_.emplace(formula, prefix_ + std::to_string(names_.size()));
  if (is_new) all_.emplace_back(place->second, formula);
  return place->second;
}

Condition Definitions::name(const Condition& formula) { return defined(formula); }
Bits Definitions::name(const Bits& word) {
  if (word.width == 0 || word.value) return word;
  return {defined(word.text), word.width};
}

Bits Definitions::free_word(unsigned width) {
  const std::string name = prefix_ + "free" + std::to_string(free_++);
  declarations_ += "(declare-const " + name + " " + sort_of(width) + ")\n";
  return {name, width};
}
Condition Definitions::free_condition() {
  const std::string name = prefix_ + "free" + std::to_string(free_++);
  declarations_ += "(declare-const " + name + " Bool)\n";
  return name;
}

Bits Definitions::unary(const char* head, const Bits& a) {
  return name(Bits{applied(head, a.text), a.width});
}
Bits Definitions::binary(const char* head, const Bits& a, const Bits& b) {
  if (a.width == 0) return a;
  if (a.value && b.value && a.width <= 64)
    if (const auto value = folded(head, *a.value, *b.value, a.width)) return constant(*value, a.width);
  return name(Bits{applied(head, a.text, b.text), a.width});
}
Bits Definitions::concat(const Bits& high, const Bits& low) {
  if (high.width == 0) return low;
  if (low.width == 0) return high;
  const unsigned width = high.width + low.width;
  if (high.value && low.value && width <= 64) return constant(*high.value << low.width | *low.value, width);
  return name(Bits{applied("concat", high.text, low.text), width});
}
Bits Definitions::extract(const Bits& a, unsigned high, unsigned low) {
  const unsigned width = high - low + 1;
  if (width == a.width) return a;
  if (a.value) return constant(low < 64 ? *a.value >> low : 0, width);
  return name(
      Bits{applied("(_ extract " + std::to_string(high) + " " + std::to_string(low) + ")", a.text), width});
}
Bits Definitions::widened(const Bits& a, unsigned width) {
  if (a.width == 0) return zeros(width);
  if (width == a.width) return a;
  if (a.value) return constant(*a.value, width);
  return name(Bits{applied("(_ zero_extend " + std::to_string(width - a.width) + ")", a.text), width});
}
Bits Definitions::widened_with_sign(const Bits& a, unsigned width) {
  return name(Bits{applied("(_ sign_extend " + std::to_string(width - a.width) + ")", a.text), width});
}
Bits Definitions::lowest(const Bits& a, unsigned width) {
  if (width >= a.width) return widened(a, width);
  return width == 0 ? Bits{} : extract(a, width - 1, 0);
}
Bits Definitions::shifted_down(const Bits& a, unsigned k) {
  return k >= a.width ? zeros(a.width) : widened(extract(a, a.width - 1, k), a.width);
}
Bits Definitions::choose_word(const Condition& c, const Bits& a, const Bits& b) {
  if (c == "true" || a.text == b.text) return a;
  if (c == "false") return b;
  return name(Bits{"(ite " + c + " " + a.text + " " + b.text + ")", a.width});
}
Condition Definitions::equal(const Bits& a, const Bits& b) {
  if (a.width == 0) return "true";
  if (a.value && b.value) return *a.value == *b.value ? "true" : "false";
  return name(Condition(applied("=", a.text, b.text)));
}
Condition Definitions::below(const Bits& a, const Bits& b) {
  if (a.width == 0) return "false";
  if (a.value && b.value) return *a.value < *b.value ? "true" : "false";
  return asked("bvult", a, b);
}
Condition Definitions::asked(const char* head, const Bits& a, const Bits& b) {
  return name(Condition(applied(head, a.text, b.text)));
}
Condition Definitions::is_zero(const Bits& a) { return equal(a, zeros(a.width)); }
Condition Definitions::bit(const Bits& a, unsigned k) { return equal(extract(a, k, k), constant(1, 1)); }
Bits Definitions::of_condition(const Condition& c, unsigned width) {
  return choose_word(c, constant(1, width), constant(0, width));
}

}  // namespace mmverify::source
