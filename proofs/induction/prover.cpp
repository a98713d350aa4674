#include "proofs/induction/prover.hpp"

#include <z3++.h>

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

}  // namespace

Found ask_z3(const Statement& statement, const Effort& effort) {
  try {
    z3::context context;
    z3::solver solver(context);
    z3::params limits(context);
    limits.set("timeout", effort.milliseconds);
    // z3 would take Ctrl-C for itself.
    limits.set("ctrl_c", false);
    if (effort.steps != 0) limits.set("rlimit", effort.steps);
    solver.set(limits);
    const z3::expr_vector assertions = context.parse_string(statement.text.c_str());
    if (assertions.empty()) return {Answer::unknown, "the statement asserts nothing"};
    solver.add(assertions);
    switch (solver.check()) {
      case z3::unsat:
        return {Answer::unsat, {}};
      case z3::sat:
        return {Answer::sat, constants_of(solver.get_model())};
      case z3::unknown:
        break;
    }
    return {Answer::unknown, solver.reason_unknown()};
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
