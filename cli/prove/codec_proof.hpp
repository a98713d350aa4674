// One law of a codec, proved from its source or refuted on the compiled codec.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/prove/second_solver.hpp"
#include "proofs/codecs/laws.hpp"
#include "proofs/engine/result.hpp"
#include "subjects/dock/library.hpp"
#include "subjects/source/codec.hpp"

namespace mmverify::cli {

/// The bounds of a proof, and its listeners.
struct CodecBudget {
  double seconds = 60;  ///< for one law at one level in one format
  std::function<void()> stop;
  std::function<void(std::uint64_t lemmas, std::uint64_t open)> progress;
  std::string certificates;               ///< the folder where proofs leave theirs; empty: none
  SecondSolver* second_solver = nullptr;  ///< asked about each proof; null: none
};

/// The outcome of a case that is run on the compiled codec again.
struct CodecReplay {
  proofs::codecs::Question question;
  source::CodecRun run;
};

class CodecProof {
 public:
  /// Compiles and loads the codec.  `timeout_seconds`: for a call of the compiled codec.
  /// Errors: as of source::Codec; EnvironmentError.
  CodecProof(const std::string& file, const std::vector<std::string>& flags, double timeout_seconds);

  const proofs::codecs::Facts& facts() const { return facts_; }
  const dock::LibraryPtr& library() const { return library_; }

  /// proved: the prover discharged each of the law's questions.  refuted: a run of the compiled codec fails on the
  /// prover's case.  incomplete: the budget is spent, no run fails, or a second solver disagrees.  not_applicable: the prover cannot read the codec,
  /// or a harness has too little room.
  proofs::Result judge(const proofs::codecs::CodecLaw& law, proofs::Level level, unsigned format,
                       const CodecBudget& budget);

  /// Runs a case's text again on the compiled codec; nothing if it is no case of the law at that level.
  std::optional<CodecReplay> replay(const proofs::codecs::CodecLaw& law, proofs::Level level,
                                    const std::string& text);

  /// The command that runs a case of the law again, without --case LEVEL@CASE.
  std::string replayed_by(const std::string& law) const;

  /// The law's result without its verdict.
  proofs::Result named(const proofs::codecs::CodecLaw& law, proofs::Level level, unsigned format) const;

 private:
  /// The file that a question's proof leaves; empty: none.
  std::string certificate_of(const proofs::Result& r, const proofs::codecs::Question& q,
                             const CodecBudget& budget) const;
  /// Checks the certificate, and asks the second solver.  The reason why the proof does not count, if any.
  /// Errors: certificate::NotValid; what budget.stop throws.
  std::optional<std::string> doubt(proofs::Result& r, const proofs::codecs::Question& q,
                                   const std::string& certificate, const CodecBudget& budget) const;
  using Questions = std::vector<proofs::codecs::Question>;
  /// Asks them one after another, until one is not proved.
  void ask(proofs::Result& r, const Questions& questions, const CodecBudget& budget);
  void settle(proofs::Result& r, const Questions& questions, const CodecBudget& budget);
  void refute(proofs::Result& result, const proofs::codecs::Question& question,
              const source::CodecAnswer& answer, const CodecBudget& budget);

  std::string file_, source_, read_as_;
  std::shared_ptr<source::Codec> codec_;
  dock::LibraryPtr library_;
  proofs::codecs::Facts facts_;
  std::set<std::string> steps_;  ///< of contracts, proved
};

}  // namespace mmverify::cli
