#include "proofs/induction/prover.hpp"

#include <z3++.h>

#include <future>
#include <map>
#include <memory>
#include <mutex>

namespace mmverify::proofs::induction {
namespace {

std::string constants_of(const z3::model& model) {
  std::string text;
  for (unsigned k = 0; k < model.num_consts(); ++k) {
    const z3::func_decl constant = model.get_const_decl(k);
    text += (text.empty() ? "" : " ") + constant.name().str() + "=" +
            model.get_const_interp(constant).to_string();
  }
  return text;
}

/// z3's count of the steps that a context took.
std::uint64_t steps_of(const z3::solver& solver) {
  const z3::stats counts = solver.statistics();
  for (unsigned k = 0; k < counts.size(); ++k)
    if (counts.key(k) == "rlimit count") return counts.uint_value(k);
  return 0;
}

/// The answers of z3 in this process, by the statements' texts: laws share statements.  Threads share it; a thread that
/// asks what another one is asking waits for it.
class Settled {
 public:
  /// The answer kept under the text; else the answer of `ask`, which is kept unless it is `unknown`.
  template <class Ask>
  ProverAnswer answer(const std::string& text, Ask ask) {
    std::promise<ProverAnswer> mine;
    std::shared_future<ProverAnswer> other;
    {
      const std::lock_guard hold(lock_);
      const auto [at, is_new] = found_.try_emplace(text);
      if (is_new)
        at->second = mine.get_future().share();
      else
        other = at->second;
    }
    if (other.valid()) return other.get();
    const ProverAnswer found = ask();
    mine.set_value(found);
    if (found.answer == Answer::unknown) {
      const std::lock_guard hold(lock_);
      found_.erase(text);
    }
    return found;
  }

 private:
  std::mutex lock_;
  std::map<std::string, std::shared_future<ProverAnswer>> found_;
};

ProverAnswer ask_anew(const Statement& statement, const Effort& effort) {
  try {
    z3::context context;
    z3::solver solver(context);
    z3::params limits(context);
    limits.set("timeout", effort.milliseconds);
    // The setting keeps z3 from catching Ctrl-C.
    limits.set("ctrl_c", false);
    if (effort.steps != 0) limits.set("rlimit", effort.steps);
    solver.set(limits);
    const z3::expr_vector assertions = context.parse_string(statement.text.c_str());
    if (assertions.empty()) return {Answer::unknown, "the statement asserts nothing"};
    solver.add(assertions);
    const z3::check_result result = solver.check();
    const std::uint64_t steps = steps_of(solver);
    if (result == z3::unsat) return {Answer::unsat, {}, steps};
    if (result == z3::sat) return {Answer::sat, constants_of(solver.get_model()), steps};
    return {Answer::unknown, solver.reason_unknown(), steps};
  } catch (const z3::exception& error) {
    return {Answer::unknown, error.msg()};
  }
}

}  // namespace

bool has_prover() { return true; }
std::string no_prover_text() { return {}; }

ProverAnswer ask_z3(const Statement& statement, const Effort& effort) {
  // Another effort may settle a statement differently, so it is not looked up.
  constexpr Effort usual;
  if (effort.milliseconds != usual.milliseconds || effort.steps != usual.steps)
    return ask_anew(statement, effort);
  static Settled settled;
  return settled.answer(statement.text, [&] { return ask_anew(statement, effort); });
}

Solved ask_words(const Statement& statement, const Effort& effort) {
  // A context remembers all names; after some statements that costs more than a new context.
  constexpr int statements_a_context = 64;
  thread_local std::unique_ptr<z3::context> context;
  thread_local int asked = 0;
  if (asked++ % statements_a_context == 0) context = std::make_unique<z3::context>();
  try {
    z3::solver solver(*context, "QF_BV");
    z3::params limits(*context);
    limits.set("timeout", effort.milliseconds);
    limits.set("ctrl_c", false);
    if (effort.steps != 0) limits.set("rlimit", effort.steps);
    solver.set(limits);
    const z3::expr_vector assertions = context->parse_string(statement.text.c_str());
    if (assertions.empty()) return {Answer::unknown, "the statement asserts nothing"};
    solver.add(assertions);
    const z3::check_result result = solver.check();
    if (result == z3::unsat) return {Answer::unsat};
    if (result == z3::unknown) return {Answer::unknown, solver.reason_unknown()};
    Solved found{Answer::sat};
    const z3::model model = solver.get_model();
    for (unsigned k = 0; k < model.num_consts(); ++k) {
      const z3::func_decl constant = model.get_const_decl(k);
      const z3::expr value = model.get_const_interp(constant);
      if (std::uint64_t word = 0; value.is_bv() && value.is_numeral_u64(word))
        found.values[constant.name().str()] = word;
    }
    return found;
  } catch (const z3::exception& error) {
    return {Answer::unknown, error.msg()};
  }
}

std::string prover_name() {
  unsigned major = 0, minor = 0, build = 0, revision = 0;
  Z3_get_version(&major, &minor, &build, &revision);
  return "z3 " + std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(build);
}

}  // namespace mmverify::proofs::induction
