// Results as lines for a person.
#pragma once

#include <cstdio>
#include <vector>

#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

/// The text with what a terminal would obey written out: it may quote a file or an argument.
std::string printable(const std::string& text);

/// The command that shows a counterexample again.
std::string replay_command(const proofs::Result& result, const proofs::Counterexample& c);

/// "refuted LAW level N case C (hex) expected E got G   replay: ..."
std::string counterexample_line(const proofs::Result& result, const proofs::Counterexample& c);

/// Prints results as they come, to `out`: a line a level, or one line a law and subject.
class TextReport {
 public:
  TextReport(std::FILE* out, bool by_level) : out_(out), by_level_(by_level) {}
  void add(const proofs::Result& result);
  /// A line of its own, before the results.
  void note(const std::string& line);
  /// The mutants, each subject's overall verdict, and the sum.
  void finish(const proofs::Report& report, bool name_subjects);

 private:
  void flush();
  void line(const std::vector<proofs::Result>& results);
  /// What a broken subject did, and on how many cases.
  void say_breaks(const proofs::Result& result) const;
  /// Which mutants were killed, by law; returns how many.
  std::size_t print_mutants(const std::vector<proofs::MutantResult>& mutants) const;

  std::FILE* out_;
  bool by_level_;
  std::vector<proofs::Result> pending_;
};

}  // namespace mmverify::cli
