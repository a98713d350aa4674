// Formulas of SMT-LIB 2 as trees: what a specification's template computes when it is run on names.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace mmverify::proofs::induction {

/// An application `(head of...)` or, without arguments, a name or a literal.  Immutable, shared.
class Term {
 public:
  Term(std::string head, std::string sort, std::vector<Term> of = {});

  const std::string& head() const { return node_->head; }
  const std::string& sort() const { return node_->sort; }
  const std::vector<Term>& of() const { return node_->of; }
  const void* id() const { return node_.get(); }

  /// The same formula, letter by letter.
  friend bool operator==(const Term& a, const Term& b);

 private:
  struct Node {
    std::string head, sort;
    std::vector<Term> of;
  };
  std::shared_ptr<const Node> node_;
};

inline const std::string boolean = "Bool", integer = "Int", real = "Real";

/// The sort of words of so many bits.
std::string word_sort(unsigned bits);

Term apply(const std::string& head, std::vector<Term> of, const std::string& sort);
Term whole_number(long long k);
Term to_real(const Term& i);
Term both(std::vector<Term> conditions);
Term no(const Term& condition);
Term equal(const Term& a, const Term& b);
/// (ite condition yes other); `yes` alone where the two are the same.
Term choose(const Term& condition, const Term& yes, const Term& other);

}  // namespace mmverify::proofs::induction
