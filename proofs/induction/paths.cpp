#include "proofs/induction/paths.hpp"

#include <stdexcept>

namespace mmverify::proofs::induction {
namespace {
thread_local Walk* in_progress = nullptr;
}

Walk::Walk(std::vector<bool> script) : script_(std::move(script)), outer_(in_progress) { in_progress = this; }
Walk::~Walk() { in_progress = outer_; }

bool Walk::ask(const Term& condition) {
  const bool answer = trail_.size() < script_.size() ? script_[trail_.size()] : true;
  trail_.push_back({condition, answer});
  return answer;
}

std::vector<bool> Walk::next() const {
  std::vector<bool> answers;
  for (const Decision& d : trail_) answers.push_back(d.answer);
  while (!answers.empty() && !answers.back()) answers.pop_back();
  if (!answers.empty()) answers.back() = false;
  return answers;
}

bool decided(const Term& condition) {
  if (in_progress == nullptr) throw std::logic_error("a branch on a name outside of every_path");
  return in_progress->ask(condition);
}

}  // namespace mmverify::proofs::induction
