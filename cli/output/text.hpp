// Results as lines of text.
#pragma once

#include <cstdio>
#include <vector>

#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

/// The text with control characters escaped: it may quote a file or an argument.
std::string printable(const std::string& text);

/// The command that replays a counterexample.
std::string replay_command(const proofs::Result& result, const proofs::Counterexample& c);

/// The line "refuted LAW level N case C (hex) expected E got G   replay: ...". Of a case above `most` characters,
/// C has the beginning.
std::string counterexample_line(const proofs::Result& result, const proofs::Counterexample& c,
                                std::size_t most = std::string::npos);

/// The last line of a run: its results by verdict, the mutants, the time.
std::string sum_line(const proofs::Report& report);

/// Prints results as they come, to `out`: a line for each level, or one for each law and subject.
class TextReport {
 public:
  TextReport(std::FILE* out, bool by_level) : out_(out), by_level_(by_level) {}
  void add(const proofs::Result& result);
  /// Prints a line before the results.
  void note(const std::string& line);
  /// Prints the mutants, each subject's overall verdict, and the sum.
  void finish(const proofs::Report& report, bool name_subjects);

 private:
  void flush();
  void line(const std::vector<proofs::Result>& results);
  /// Prints how a broken subject failed, and on how many cases.
  void say_breaks(const proofs::Result& result) const;
  /// Prints the mutants by law, killed or survived.
  void print_mutants(const std::vector<proofs::MutantResult>& mutants) const;

  std::FILE* out_;
  bool by_level_;
  std::vector<proofs::Result> pending_;
};

}  // namespace mmverify::cli
