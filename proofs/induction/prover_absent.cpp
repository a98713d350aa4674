// A replacement of prover.cpp for builds without z3, such as WebAssembly.
#include "proofs/induction/prover.hpp"

namespace mmverify::proofs::induction {

bool has_prover() { return false; }
std::string no_prover_text() { return "built without z3, which proves it; the native mmverify has it"; }

ProverAnswer ask_z3(const Statement&, const Effort&) { return {Answer::unknown, no_prover_text()}; }
Solved ask_words(const Statement&, const Effort&) { return {Answer::unknown, no_prover_text()}; }
std::string prover_name() { return "no prover"; }

}  // namespace mmverify::proofs::induction
