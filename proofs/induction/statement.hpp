// A statement for a prover: one self-contained file of SMT-LIB 2.
#pragma once

#include <map>

#include "proofs/induction/term.hpp"

namespace mmverify::proofs::induction {

/// A prover's answer: the assertions have no model, they have one, or it gave up.
enum class Answer { unsat, sat, unknown };

std::string to_string(Answer a);

/// A statement.  unsat: the assertions deny its claim; sat: they are hypotheses, which some case fulfils.
struct Statement {
  std::string name;  ///< the name of its file, without .smt2
  Answer expected = Answer::unsat;
  std::string text;
};

/// Builds a statement line by line.
class Script {
 public:
  /// `claim`: the statement in words, for the head of the file.
  Script(std::string name, Answer expected, const std::string& claim);

  void comment(const std::string& words);
  /// Adds commands unchanged; the last line must end with a line break.
  void raw(const std::string& commands) { body_ += commands; }
  Term declare(const std::string& name, const std::string& sort);
  /// Defines a name for a formula, for later commands.  Large formulas that occur twice inside get names as well.
  Term define(const std::string& name, const Term& formula);
  void require(const Term& condition);
  /// Finishes the statement with the assertion that not all claims hold.
  Statement denying(std::vector<Term> claims);
  /// Finishes the statement without a further assertion.
  Statement finish();

 private:
  std::size_t key(const Term& t);
  void count(const Term& t, std::map<std::size_t, int>& uses);
  std::string print(const Term& t, std::map<std::size_t, int>& uses);
  std::string text_of(const Term& t);

  std::string name_, head_, body_;
  Answer expected_;
  std::map<std::string, std::size_t> keys_;    ///< the key of a formula, written with its parts' keys
  std::map<const void*, std::size_t> key_of_;  ///< the key by the formula's place in memory
  std::vector<Term> alive_;                    ///< keeps these places in use
  std::map<std::size_t, std::string> names_;
  std::map<std::size_t, std::size_t> length_;
  std::size_t helpers_ = 0;
};

}  // namespace mmverify::proofs::induction
