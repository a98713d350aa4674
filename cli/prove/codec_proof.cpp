#include "cli/prove/codec_proof.hpp"

#include <fmt/format.h>

#include <chrono>
#include <fstream>

#include "cli/arguments/arguments.hpp"
#include "cli/output/exit_code.hpp"
#include "proofs/certificate/checker.hpp"
#include "proofs/codecs/case_text.hpp"
#include "proofs/engine/bytes.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/registry/plugin.hpp"
#include "proofs/registry/registry.hpp"

namespace mmverify::cli {

using namespace proofs;
using codecs::CodecLaw;
using codecs::Question;

namespace {

source::HarnessCall call_of(const Question& q) { return {q.file, q.function, q.level, q.format, q.size}; }

/// The prover's choices as the numbers of a case: what it left open is 0.
std::vector<std::uint64_t> numbers_of(const Question& question, const std::vector<source::Choice>& choices) {
  std::vector<std::uint64_t> numbers;
  for (const source::Choice& choice : choices) numbers.push_back(choice.number);
  numbers.resize(static_cast<std::size_t>(codecs::count_of(question)));
  return numbers;
}

std::string no_room(const Question& question) {
  return fmt::format("its code has more than {} bytes, for which the law's harness has no room",
                     question.size);
}

std::uint64_t& statements(Result& r) { return r.by_kind[kinds - 1].cases; }

/// Levels whose certificates are written and checked without being asked for.
constexpr Level certified_to = 2;

/// Levels whose proofs a second solver is asked about whole; of higher ones it is asked about a sample.
constexpr Level asked_whole_to = 2;

std::string with_words(const std::string& method, const std::string& words) {
  return method.find(words) != std::string::npos ? method : method + words;
}

/// The name of what a proof leaves, without the end.
std::string proof_name(const Result& r, const Question& q) {
  return fmt::format("{}.level_{}.{}.{}.{}", r.law, q.level, codecs::format_name(q.format), q.function,
                     q.size);
}

/// The name of a step of a contract, which several laws and levels need; empty for other questions.
std::string step_name(const Question& q) {
  if (!q.by_contract || !q.function.starts_with("step_")) return {};
  return fmt::format("{} {} {} {}", q.function, q.level, q.format, q.size);
}

/// Throws NotValid if a step of the certificate does not follow.
void check_certificate(const std::string& file, const std::function<void()>& stop) {
  std::ifstream in(file);
  if (!in) throw certificate::NotValid("it was not written");
  std::uint64_t line = 0;
  certificate::check(in, [&] {
    if (stop && ++line % 1024 == 0) stop();
  });
}

}  // namespace

CodecProof::CodecProof(const std::string& file, const std::vector<std::string>& flags, double timeout_seconds)
    : file_(file), codec_(std::make_shared<source::Codec>(file, flags, codecs::texts())) {
  source_ = "--source " + shell_quoted(file);
  read_as_ = "LLVM bitcode of " + codec_->compiler();
  for (const std::string& flag : flags) {
    source_ += " --flag=" + shell_quoted(flag);
    read_as_ += " " + flag;
  }
  dock::Options dock;
  dock.timeout_seconds = timeout_seconds;
  dock.called = file;
  dock.keeps = codec_->files();
  dock.fingerprint = fmt::format("{} {:016x}", codec_->compiler(), hash_of(codec_->bitcode()));
  try {
    library_ = open_library(codec_->library(), dock);
  } catch (const dock::CannotLoad& why) {
    throw EnvironmentError(fmt::format("{}: {}", file, why.what()));
  } catch (const dock::NotHere& why) {
    throw EnvironmentError(fmt::format("{}: {}", file, why.what()));
  }
  facts_ = {[library = library_](dock::Call call) { return library->offers(call); },
            library_->description().flags, library_->description().max_level,
            [bitcode = codec_->bitcode()](const std::string& symbol) {
              return bitcode.find(symbol) != std::string::npos;
            }};
}

std::string CodecProof::replayed_by(const std::string& law) const {
  return fmt::format("mmverify prove {} {}", law, source_);
}

Result CodecProof::named(const CodecLaw& law, Level level, unsigned format) const {
  const Law& registered = *find_law(law.id);
  Result r;
  r.law = law.id;
  r.topic = registered.topic;
  r.subject = file_;
  r.level = level;
  r.at_once = registered.at_once;
  r.proof = "SAT";
  r.method = "SAT, mmverify-codec; " + read_as_;
  r.domain = law.domain(level, format);
  if (format != 0) r.domain = codecs::format_name(format) + " " + r.domain;
  r.fingerprint = library_->fingerprint();
  r.replayed_by = replayed_by(law.id);
  return r;
}

void CodecProof::refute(Result& r, const Question& question, const source::CodecAnswer& answer,
                        const CodecBudget& budget) {
  if (question.by_contract) {
    r.verdict = Verdict::incomplete;
    r.reason = fmt::format(
        "not proved by contract: {} at level {}, with the level below as the contract allows: {}; this is no "
        "counterexample",
        question.function, question.level, answer.text);
    return;
  }
  const std::vector<std::uint64_t> numbers = numbers_of(question, answer.choices);
  const std::string at = codecs::text_of(question, numbers);
  const source::CodecRun run = codec_->run(call_of(question), answer.choices, budget.stop);
  if (run.no_room) {
    r.verdict = Verdict::not_applicable;
    r.reason = no_room(question);
  } else if (!run.fails) {
    r.verdict = Verdict::incomplete;
    r.reason = fmt::format(
        "case {}: by the formula {}, and the compiled codec keeps the law there, under AddressSanitizer, "
        "UndefinedBehaviorSanitizer and MemorySanitizer, too; nothing is proved",
        at, answer.text);
  } else {
    r.verdict = Verdict::refuted;
    ++r.by_kind[kinds - 1].mismatches;
    // A failed check is the run's to name, with its values; another fault is the prover's.
    const bool by_check = answer.text.ends_with("the check fails");
    const bool valued = by_check && !run.expected.empty();
    r.counterexamples.push_back({{},
                                 question.level,
                                 at,
                                 {},
                                 valued ? run.expected : "the law",
                                 by_check ? run.how : answer.text + "; " + run.text()});
  }
}

std::string CodecProof::certificate_of(const Result& r, const Question& q, const CodecBudget& budget) const {
  if (!budget.certificates.empty()) return budget.certificates + "/" + proof_name(r, q) + ".certificate";
  const bool wanted = q.level <= certified_to || budget.second_solver != nullptr;
  return wanted ? codec_->files()->file("certificate") : "";
}

std::optional<std::string> CodecProof::doubt(Result& r, const Question& q, const std::string& certificate,
                                             const CodecBudget& budget) const {
  if (certificate.empty()) return std::nullopt;
  check_certificate(certificate, budget.stop);
  r.method = with_words(r.method, ", certificate checked");
  if (budget.second_solver == nullptr) return std::nullopt;
  const std::string kept =
      (budget.certificates.empty() ? "" : budget.certificates + "/") + proof_name(r, q) + ".cnf";
  const auto why = budget.second_solver->disagrees(certificate, q.level <= asked_whole_to, kept,
                                                   budget.seconds, budget.stop);
  if (!why) r.method = with_words(r.method, ", " + budget.second_solver->program() + " agrees");
  return why;
}

void CodecProof::settle(Result& r, const Questions& questions, const CodecBudget& budget) {
  const auto begun = std::chrono::steady_clock::now();
  const auto left = [&] {
    return budget.seconds - std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  };
  r.cases_expected = questions.size();
  r.verdict = Verdict::proved;
  for (const Question& question : questions) {
    const std::string name = step_name(question);
    if (steps_.contains(name)) {
      ++statements(r);
      continue;
    }
    source::CodecAnswer answer;
    const std::string certificate = certificate_of(r, question, budget);
    if (left() > 0)
      answer = codec_->prove(call_of(question), {left(), budget.stop, budget.progress, certificate});
    if (answer.kind == source::CodecAnswer::Kind::refuted) {
      ++statements(r);
      return refute(r, question, answer, budget);
    }
    r.verdict = Verdict::incomplete;
    if (answer.kind == source::CodecAnswer::Kind::unknown) {
      r.reason = fmt::format("not settled within {:g} s; {} of {} statements proved{}{}", budget.seconds,
                             statements(r), questions.size(), answer.text.empty() ? "" : "; ", answer.text);
      return;
    }
    if (const auto why = doubt(r, question, certificate, budget)) {
      r.reason = *why;
      return;
    }
    r.verdict = Verdict::proved;
    if (!name.empty()) steps_.insert(name);
    ++statements(r);
  }
}

void CodecProof::ask(Result& r, const Questions& questions, const CodecBudget& budget) {
  try {
    settle(r, questions, budget);
  } catch (const certificate::NotValid& why) {
    r.verdict = Verdict::incomplete;
    r.reason = fmt::format(
        "the certificate of the solver is not valid: {}; the mistake is mmverify's, please report it",
        why.what());
  } catch (const Interrupted&) {
    r.verdict = Verdict::incomplete;
    r.reason = "interrupted";
  } catch (const source::UnknownInstruction& why) {
    r.verdict = Verdict::not_applicable;
    r.reason = why.what();
  }
}

Result CodecProof::judge(const CodecLaw& law, Level level, unsigned format, const CodecBudget& budget) {
  Result r = named(law, level, format);
  const auto begun = std::chrono::steady_clock::now();
  const Questions by_contract = codecs::questions_by_contract(law, facts_, level, format);
  if (!by_contract.empty()) {
    r.proof = "SAT, by contract";
    r.method =
        "SAT from level to level, by the codec's contract" + r.method.substr(std::string("SAT").size());
    ask(r, by_contract, budget);
  }
  // A level that one formula may settle is settled, whatever the contract says.
  const bool within = level <= law.long_run.last || law.fixed;
  if (by_contract.empty() || (r.verdict != Verdict::proved && r.reason != "interrupted" && within)) {
    r = named(law, level, format);
    ask(r, codecs::questions(law, facts_, level, format), budget);
  }
  r.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  return r;
}

std::optional<CodecReplay> CodecProof::replay(const CodecLaw& law, Level level, const std::string& text) {
  for (const unsigned format : law.formats) {
    if (codecs::unfit(law, facts_, level, format)) continue;
    for (const Question& question : codecs::questions(law, facts_, level, format)) {
      const auto numbers = codecs::numbers_of(question, text);
      if (!numbers) continue;
      std::vector<source::Choice> choices;
      for (const std::uint64_t number : *numbers) choices.push_back({0, number});
      return CodecReplay{question, codec_->run(call_of(question), choices)};
    }
  }
  return std::nullopt;
}

}  // namespace mmverify::cli
