#include "proofs/registry.hpp"

#include "proofs/bake/laws.hpp"
#include "proofs/index/built_in.hpp"
#include "proofs/index/laws.hpp"
#include "proofs/micromap/laws.hpp"
#include "proofs/tree/laws.hpp"
#include "proofs/vq/laws.hpp"

namespace mmverify::proofs {
namespace {

template <class T>
void append(std::vector<T>& all, const auto& more) {
  all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

const std::vector<Law>& laws() {
  static const std::vector<Law> all = [] {
    std::vector<Law> of_all_topics;
    append(of_all_topics, index::laws());
    append(of_all_topics, micromap::laws());
    append(of_all_topics, tree::laws());
    append(of_all_topics, vq::laws());
    append(of_all_topics, bake::laws());
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

Level max_level() { return index::max_level; }

std::vector<SubjectPtr> subjects() {
  std::vector<SubjectPtr> of_all_topics;
  append(of_all_topics, index::built_in_subjects());
  append(of_all_topics, micromap::built_in_subjects());
  append(of_all_topics, tree::built_in_subjects());
  append(of_all_topics, vq::built_in_subjects());
  append(of_all_topics, bake::built_in_subjects());
  return of_all_topics;
}

SubjectPtr subject_that_answers(std::uint32_t index) { return index::given_answer(index); }

SubjectPtr find_subject(const std::string& name) {
  for (const SubjectPtr& subject : subjects())
    if (subject->name() == name) return subject;
  return nullptr;
}

}  // namespace mmverify::proofs
