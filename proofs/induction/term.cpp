#include "proofs/induction/term.hpp"

#include <utility>

namespace mmverify::proofs::induction {

Term::Term(std::string head, std::string sort, std::vector<Term> of)
    : node_(std::make_shared<const Node>(Node{std::move(head), std::move(sort), std::move(of)})) {}

bool operator==(const Term& a, const Term& b) {
  return a.id() == b.id() || (a.head() == b.head() && a.sort() == b.sort() && a.of() == b.of());
}

std::string word_sort(unsigned bits) { return "(_ BitVec " + std::to_string(bits) + ")"; }

Term apply(const std::string& head, std::vector<Term> of, const std::string& sort) {
  return {head, sort, std::move(of)};
}

Term whole_number(long long k) {
  const Term size(std::to_string(k < 0 ? -k : k), integer);
  return k < 0 ? apply("-", {size}, integer) : size;
}

Term to_real(const Term& i) {
  // A literal is written as a real one.
  if (i.of().empty() && i.head().find_first_not_of("0123456789") == std::string::npos)
    return {i.head() + ".0", real};
  return apply("to_real", {i}, real);
}

Term both(std::vector<Term> conditions) { return apply("and", std::move(conditions), boolean); }
Term no(const Term& condition) { return apply("not", {condition}, boolean); }
Term equal(const Term& a, const Term& b) { return apply("=", {a, b}, boolean); }

Term choose(const Term& condition, const Term& yes, const Term& other) {
  return yes == other ? yes : apply("ite", {condition, yes, other}, yes.sort());
}

}  // namespace mmverify::proofs::induction
