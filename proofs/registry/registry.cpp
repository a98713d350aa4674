#include "proofs/registry/registry.hpp"

#include <algorithm>

#include "proofs/induction/prover.hpp"
#include "proofs/registry/topics.hpp"

namespace mmverify::proofs {

namespace {

/// A prover's law where there is none: it says so of each subject, and cannot fail.
void without_prover(Law& law) {
  law.unfit = [](const Subject&, Level) { return std::optional(induction::no_prover_text()); };
  law.mutants.clear();
}

}  // namespace

const std::vector<Law>& laws() {
  static const std::vector<Law> all = [] {
    std::vector<Law> of_all_topics;
    for (const Topic& topic : topics())
      for (Law& law : topic.laws()) {
        law.topic = topic.name;
        const bool of_prover = law.method == Method::induction || law.method == Method::bit_vectors;
        if (of_prover && !induction::has_prover()) without_prover(law);
        of_all_topics.push_back(std::move(law));
      }
    return of_all_topics;
  }();
  return all;
}

const Law* find_law(const std::string& id) {
  for (const Law& law : laws())
    if (law.id == id) return &law;
  return nullptr;
}

std::vector<const Law*> laws_named(const std::string& name) {
  std::vector<const Law*> found;
  for (const Law& law : laws())
    if (law.id == name || law.topic == name || law.id.substr(0, law.id.find('.')) == name)
      found.push_back(&law);
  return found;
}

Level max_level() {
  Level highest = 0;
  for (const Topic& topic : topics()) highest = std::max(highest, topic.highest);
  return highest;
}

std::vector<SubjectPtr> subjects() {
  std::vector<SubjectPtr> of_all_topics;
  for (const Topic& topic : topics())
    for (SubjectPtr& subject : topic.subjects()) of_all_topics.push_back(std::move(subject));
  return of_all_topics;
}

SubjectPtr find_subject(const std::string& name) {
  for (const SubjectPtr& subject : subjects())
    if (subject->name() == name) return subject;
  return nullptr;
}

}  // namespace mmverify::proofs
