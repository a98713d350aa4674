// Terms for the statements of dag.all_levels: parts of a graph, their meaning, and names that the specification's
// templates take.
#pragma once

#include "proofs/induction/statement.hpp"
#include "proofs/induction/symbolic.hpp"
#include "spec/dag/dag.hpp"

namespace mmverify::proofs::dag::induction {

using proofs::induction::apply;
using proofs::induction::boolean;
using proofs::induction::Integer;
using proofs::induction::integer;
using proofs::induction::Script;
using proofs::induction::Statement;
using proofs::induction::Term;

inline const std::string part_sort = "Part", state_sort = "State", path_sort = "Path", map_sort = "Map";

/// Writes the definitions of parts and their meaning into a script.
void define_parts(Script& script);

Term implies(const Term& premise, const Term& conclusion);
Term said(const char* predicate, std::vector<Term> of);
Term first(const Term& path);
Term rest(const Term& path);
Term is_stored(const Term& part);
Term child(const Term& part, const Term& digit);
Term means(const Term& part, const Term& path);
Term meant(const Term& part, const Term& path);

/// A part as the templates take it.
struct Name {
  Term term;
  bool mixed() const { return proofs::induction::decided(is_stored(term)); }
  friend bool operator==(const Name& a, const Name& b) {
    return proofs::induction::decided(proofs::induction::equal(a.term, b.term));
  }
};

/// The stored children, as lookup_turn reads them.
struct Store {
  Name child(const Name& at, const Integer& digit) const { return {induction::child(at.term, digit.term)}; }
};

}  // namespace mmverify::proofs::dag::induction
