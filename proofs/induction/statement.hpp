// A statement for a prover: one self-contained file of SMT-LIB 2.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "proofs/induction/term.hpp"

namespace mmverify::proofs::induction {

/// What a prover says of the assertions: none of their models exists, one does, or it gave up.
enum class Answer { unsat, sat, unknown };

std::string to_string(Answer a);

/// unsat: the assertions deny what the statement claims; sat: they are hypotheses, which some case fulfils.
struct Statement {
  std::string name;  ///< of its file, without .smt2
  Answer expected = Answer::unsat;
  std::string text;
};

/// Puts a statement together, line by line.
class Script {
 public:
  /// `claim`: what it says, in words, at the head of the file.
  Script(std::string name, Answer expected, const std::string& claim);

  void comment(const std::string& words);
  /// Commands as they are; the last line ends with a line break.
  void raw(const std::string& commands) { body_ += commands; }
  Term declare(const std::string& name, const std::string& sort);
  /// A name for a formula; later commands use the name. Large formulas that occur twice inside get names too.
  Term define(const std::string& name, const Term& formula);
  void require(const Term& condition);
  /// Asserts that not all of the conditions hold: nothing after it.
  Statement denying(std::vector<Term> claims);
  /// Nothing more to assert.
  Statement finish();

 private:
  std::size_t key(const Term& t);
  void count(const Term& t, std::map<std::size_t, int>& uses);
  std::string print(const Term& t, std::map<std::size_t, int>& uses);
  std::string text_of(const Term& t);

  std::string name_, head_, body_;
  Answer expected_;
  std::map<std::string, std::size_t> keys_;    ///< of a formula, written with its parts' keys
  std::map<const void*, std::size_t> key_of_;  ///< the same by the formula's place in memory
  std::vector<Term> alive_;                    ///< keeps those places taken
  std::map<std::size_t, std::string> names_;
  std::map<std::size_t, std::size_t> length_;
  std::size_t helpers_ = 0;
};

}  // namespace mmverify::proofs::induction
