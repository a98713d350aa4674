#include "cli/prove/codec.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "cli/arguments/arguments.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/json.hpp"
#include "cli/output/json_output.hpp"
#include "cli/output/junit.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/streams.hpp"
#include "cli/output/text.hpp"
#include "cli/prove/codec_proof.hpp"
#include "cli/prove/short/codec_answer.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/engine/shape.hpp"
#include "proofs/engine/standard_error.hpp"
#include "proofs/registry/plugin.hpp"
#include "proofs/registry/registry.hpp"

namespace mmverify::cli {

using namespace proofs;
using codecs::CodecLaw;

namespace {

/// The codec's laws among those that are named; all, if none is.
std::vector<const CodecLaw*> laws_of(const CodecOptions& options) {
  std::vector<const CodecLaw*> all;
  const std::vector<const Law*> named =
      options.laws.empty() ? std::vector<const Law*>() : parse_laws(options.laws, Tier::long_run);
  for (const CodecLaw& law : codecs::laws())
    if (options.laws.empty() ||
        std::any_of(named.begin(), named.end(), [&](const Law* one) { return one->id == law.id; }))
      all.push_back(&law);
  for (const std::string& name : options.laws) {
    const std::vector<const Law*> meant = laws_named(name);
    if (std::none_of(all.begin(), all.end(), [&](const CodecLaw* law) {
          return std::any_of(meant.begin(), meant.end(), [&](const Law* one) { return one->id == law->id; });
        }))
      throw UsageError(fmt::format(
          "--source: {} is proved of no source; index.floats is proved of a function, and of a codec: {}",
          name, [] {
            std::string ids;
            for (const CodecLaw& law : codecs::laws()) ids += (ids.empty() ? "" : ", ") + std::string(law.id);
            return ids;
          }()));
  }
  return all;
}

/// Throws UsageError for an index function without a codec beside it: another law is proved of it.
void refuse_index_function(const CodecOptions& options, const codecs::Facts& facts) {
  const auto is_about = [&](const CodecLaw& law) {
    for (Level n = 0; n <= 5; ++n)
      for (const unsigned format : {1u, 2u})
        if (!codecs::unfit(law, facts, n, format)) return true;
    return false;
  };
  if (!facts.offers(dock::Call::index_f32) ||
      std::any_of(codecs::laws().begin(), codecs::laws().end(), is_about))
    return;
  throw UsageError(fmt::format("{}: an index function, and no codec: mmverify prove index.floats --source {}",
                               options.file, shell_quoted(options.file)));
}

/// Calls a function, with the errors of sources as those of the command.
template <class Function>
auto with_errors_of_sources(const CodecOptions& options, Function function) {
  try {
    return function();
  } catch (const source::NoSource& why) {
    throw EnvironmentError(why.what());
  } catch (const source::BadSource& why) {
    throw UsageError(why.what());
  } catch (const source::NotAvailable& why) {
    throw EnvironmentError(fmt::format("{}: {}", options.file, why.what()));
  } catch (const source::UnknownInstruction& why) {
    throw UsageError(why.what());
  }
}

/// One line a second on a terminal: how far a proof is.
class ProofProgress {
 public:
  explicit ProofProgress(bool shown) : shown_(shown && isatty(STDERR_FILENO) != 0) {}
  ~ProofProgress() { clear(); }
  ProofProgress(const ProofProgress&) = delete;
  ProofProgress& operator=(const ProofProgress&) = delete;

  void begin(const std::string& what) {
    what_ = what;
    begun_ = std::chrono::steady_clock::now();
    show("");
  }
  void add(std::uint64_t lemmas, std::uint64_t open) {
    show(fmt::format("  {} lemmas proved, {} obligations open", grouped(lemmas), grouped(open)));
  }
  void clear() const {
    if (shown_) to_standard_error("\r\033[K");
  }

 private:
  void show(const std::string& how_far) const {
    if (!shown_) return;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    to_standard_error(fmt::format("\r\033[K{:.0f} s  {}{}", seconds, what_, how_far));
  }

  bool shown_;
  std::string what_;
  std::chrono::steady_clock::time_point begun_;
};

std::string level_text(const Result& r) {
  return r.at_once.empty() ? fmt::format("level {}", r.level) : r.at_once;
}

/// The lines of a result: the verdict, the domain and the time; what is wrong, and how to see it again.
void print(std::FILE* out, const Result& r) {
  if (r.verdict == Verdict::not_applicable) {
    say(out, "{}\n",
        printable(fmt::format("{:<9} {} {} {} {}: {}", "n/a", r.law, r.subject, level_text(r), r.domain,
                              r.reason)));
    return;
  }
  const std::string verdict = codec_verdict(r.verdict, r.reason);
  const std::string by =
      r.proof.empty() ? fmt::format("{} cases", grouped(r.cases_run())) : "(" + r.proof + ")";
  say(out, "{}\n",
      printable(fmt::format("{:<9} {} {} {} {} {} {:.2f} s", verdict, r.law, r.subject, level_text(r),
                            r.domain, by, r.seconds)));
  if (r.verdict == Verdict::incomplete || r.verdict == Verdict::broken)
    say(out, "  {}\n", printable(r.reason));
  for (const Counterexample& c : r.counterexamples)
    say(out, "  case {}: {}\n  replay: {}\n", printable(c.at), printable(codec_case(c)),
        printable(replay_command(r, c)));
  std::fflush(out);
}

/// A run of the command: its laws, results and lines.
class CodecProofs {
 public:
  CodecProofs(const CodecOptions& options, std::FILE* out)
      : options_(options),
        out_(out),
        proof_(options.file, options.flags, options.timeout),
        progress_(!options.quiet) {
    refuse_index_function(options, proof_.facts());
    report_.threads = 1;
    if (!options.second_solver.empty()) second_solver_.emplace(options.second_solver);
  }

  Report run() {
    const auto begun = std::chrono::steady_clock::now();
    for (const CodecLaw* law : laws_of(options_)) judge_levels(*law);
    report_.interrupted = proofs::interrupted();
    report_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    progress_.clear();
    std::vector<std::string> end;
    if (second_solver_) end.push_back(second_solver_->sum());
    if (options_.details)
      end.push_back(sum_line(report_));
    else
      end = codec_answer(report_, end);
    for (const std::string& line : end) say(out_, "{}\n", printable(line));
    return report_;
  }

 private:
  void judge_levels(const CodecLaw& law) {
    const Levels own = options_.tier == Tier::fast ? law.fast : law.long_run;
    const Levels levels = law.fixed || !options_.levels ? own : *options_.levels;
    for (Level n = levels.first; n <= levels.last; ++n)
      for (const unsigned format : law.formats)
        if (!proofs::interrupted() &&
            (!options_.format || format == 0 || *options_.format == codecs::format_name(format)))
          judge(law, n, format);
  }

  void judge(const CodecLaw& law, Level n, unsigned format) {
    if (const auto why = codecs::unfit(law, proof_.facts(), n, format)) {
      Result r = proof_.named(law, n, format);
      r.verdict = Verdict::not_applicable;
      r.reason = *why;
      // A law that nobody asked for is no news where it does not apply.
      if (!options_.laws.empty() || options_.details) add(r);
      return;
    }
    const Result named = proof_.named(law, n, format);
    progress_.begin(fmt::format("{} {} {}", law.id, level_text(named), named.domain));
    CodecBudget budget{options_.budget,
                       [] {
                         if (proofs::interrupted()) throw Interrupted();
                       },
                       [this](std::uint64_t lemmas, std::uint64_t open) { progress_.add(lemmas, open); },
                       options_.certificates, second_solver_ ? &*second_solver_ : nullptr};
    const Result r = proof_.judge(law, n, format, budget);
    add(r);
    if (r.verdict == Verdict::incomplete && r.reason != "interrupted") sample(law, n);
  }

  /// Runs the law's sample on the compiled codec, once for both formats.
  void sample(const CodecLaw& codec_law, Level n) {
    const Law& law = *find_law(codec_law.sampled);
    const Level level = law.at_once.empty() ? n : 0;
    if (law.at_once.empty() && (n < law.tiers.fast.first || n > law.tiers.long_run.last)) return;
    if (std::any_of(report_.results.begin(), report_.results.end(),
                    [&](const Result& r) { return r.law == law.id && r.level == level && r.proof.empty(); }))
      return;
    for (const PluginSubject& one : plugin_subjects(proof_.library())) {
      if (one.subject->topic() != law.topic) continue;
      Run run;
      run.seed = options_.seed;
      run.tier = options_.tier;
      Result r = run_level(law, *one.subject, level, run);
      r.replayed_by = proof_.replayed_by(law.id);
      if (r.verdict != Verdict::not_applicable) add(r);
      return;
    }
  }

  void add(const Result& r) {
    if (options_.details) {
      progress_.clear();
      print(out_, r);
    }
    report_.results.push_back(r);
  }

  const CodecOptions& options_;
  std::FILE* out_;
  CodecProof proof_;
  std::optional<SecondSolver> second_solver_;
  ProofProgress progress_;
  Report report_;
};

/// The law of that name if a codec's sample runs it; null if none does.
const Law* sampled_law(const std::string& id) {
  const bool known = std::any_of(codecs::laws().begin(), codecs::laws().end(),
                                 [&](const CodecLaw& law) { return law.sampled == id; });
  return known ? find_law(id) : nullptr;
}

/// Runs a case of a sample on the compiled codec.
int replay_sample(const Law& law, const CodecProof& proof, Level level, const std::string& text) {
  for (const PluginSubject& one : plugin_subjects(proof.library())) {
    if (one.subject->topic() != law.topic) continue;
    if (const auto why = law.unfit(*one.subject, level))
      throw UsageError(fmt::format("{}: {}", law.id, *why));
    try {
      const Replayed r = law.replay(*one.subject, level, text);
      say(stdout, "{} {} level {} case {} subject {} expected {} got {}\n", r.holds ? "holds" : "refuted",
          law.id, level, text, one.subject->name(), r.expected, r.got);
      return r.holds ? ExitCode::complete : ExitCode::failed;
    } catch (const BadCase& error) {
      throw UsageError(fmt::format("--case {}", error.what()));
    }
  }
  throw UsageError(fmt::format("{}: the codec has none of its entry points", law.id));
}

/// Runs a counterexample, LEVEL@CASE, on the compiled codec.
int replay(const CodecOptions& options) {
  const std::string& text = *options.one_case;
  const std::size_t at = text.find('@');
  if (at == std::string::npos)
    throw UsageError(fmt::format("--case {}: write LEVEL@CASE, as a counterexample's line does", text));
  const Level level = parse_level(text.substr(0, at));
  if (options.laws.size() == 1)
    if (const Law* law = sampled_law(options.laws.front()))
      return replay_sample(*law, {options.file, options.flags, options.timeout}, level, text.substr(at + 1));
  const std::vector<const CodecLaw*> laws = laws_of(options);
  if (options.laws.size() != 1 || laws.size() != 1)
    throw UsageError("--case: name the one law that the case is of, for example tree.round_trip");
  CodecProof proof(options.file, options.flags, options.timeout);
  const auto found = proof.replay(*laws.front(), level, text.substr(at + 1));
  if (!found)
    throw UsageError(fmt::format("--case {}: it is no case of {} at level {} of this codec", text,
                                 laws.front()->id, level));
  if (found->run.no_room)
    throw UsageError(fmt::format("--case {}: the law's harness has no room for this codec's code", text));
  say(stdout, "{} {} level {} case {} subject {}{}{}\n", found->run.fails ? "refuted" : "holds",
      laws.front()->id, level, text.substr(at + 1), options.file, found->run.fails ? ": " : "",
      found->run.text());
  return found->run.fails ? ExitCode::failed : ExitCode::complete;
}

}  // namespace

bool asks_for_codec(const std::vector<std::string>& laws, bool function_named) {
  return !function_named && std::find(laws.begin(), laws.end(), "index.floats") == laws.end();
}

int prove_codec(const CodecOptions& options) {
  const InterruptGuard guard;
  if (options.one_case) return with_errors_of_sources(options, [&] { return replay(options); });
  JsonOutput json(options.json);
  std::optional<OutputFile> junit;
  if (!options.junit.empty()) junit.emplace(options.junit);
  const Report report =
      with_errors_of_sources(options, [&] { return CodecProofs(options, json.text()).run(); });
  json.write([&] { return to_json(report, options.seed); });
  if (junit) junit->commit(to_junit(report));
  refuse_nothing(report);
  return exit_code(report);
}

}  // namespace mmverify::cli
