#include "proofs/registry.hpp"

#include "proofs/index.hpp"
#include "proofs/index/built_in.hpp"

namespace mmverify::proofs {

const std::vector<Law>& laws() {
  static const std::vector<Law> all = index::laws();
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

std::vector<SubjectPtr> subjects() {
  const auto& of_index = index::built_in_subjects();
  return {of_index.begin(), of_index.end()};
}

SubjectPtr subject_that_answers(std::uint32_t index) { return index::given_answer(index); }

SubjectPtr find_subject(const std::string& name) { return index::built_in_subject(name); }

}  // namespace mmverify::proofs
