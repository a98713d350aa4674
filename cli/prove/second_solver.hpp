// A second SAT solver, a program of somebody else's, asked about the statements that the first one proved.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace mmverify::cli {

/// The number of statements that a second solver was asked about: each of a proof, or a sample of its many.
struct SecondOpinion {
  std::size_t whole = 0;               ///< statements of proofs that were asked whole
  std::size_t asked = 0, sampled = 0;  ///< asked, of so many
};

class SecondSolver {
 public:
  /// A program that takes a DIMACS file and exits with 10 if some values satisfy it, with 20 if none do.
  explicit SecondSolver(std::string program) : program_(std::move(program)) {}

  /// Asks about the statements of a certificate.  `whole`: about all in one question, without the first solver's merges;
  /// else, and where the program does not answer that in time, about a sample, each after the statements before it.  A
  /// question that is not answered as the first solver did is left in the file `kept`.
  /// Returns what is wrong, if anything is.  Errors: EnvironmentError if there is no such program; what `stop` throws.
  /// Test: codec_command_test.
  std::optional<std::string> disagrees(const std::string& certificate, bool whole, const std::string& kept,
                                       double seconds, const std::function<void()>& stop);

  const std::string& program() const { return program_; }
  /// "minisat agrees: 812 statements, all of a proof at once; 64 of 3,120 statements, one by one".
  std::string sum() const;

 private:
  struct Answer {
    enum class Kind { impossible, possible, none } kind;
    std::string why;
  };
  Answer ask(const std::string& file, double seconds, const std::function<void()>& stop) const;

  std::string program_;
  SecondOpinion opinion_;
};

}  // namespace mmverify::cli
