#include "proofs/registry/registry.hpp"

#include "proofs/attribute/induction/provable.hpp"
#include "proofs/dag/induction/provable.hpp"
#include "proofs/index/binary32/law.hpp"
#include "proofs/index/induction/provable.hpp"
#include "proofs/induction/prover.hpp"
#include "proofs/registry/topics.hpp"
#include "proofs/tree/induction/provable.hpp"

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

std::map<std::string, induction::Statement> shipped_statements() {
  std::map<std::string, induction::Statement> all;
  const auto add = [&](const std::string& folder, const auto& statements) {
    for (const auto& s : statements) all.emplace(folder + "/" + s.name, s);
  };
  add("index/all_levels", index::induction::shipped_all_levels());
  add("index/wide_is_vulkan", index::induction::shipped_wide_is_vulkan());
  add("index/impl_wide_is_wide", index::induction::shipped_impl_wide());
  add("index/floats", index::binary32::shipped());
  add("index/row_floats", index::binary32::shipped_rows());
  add("index/published_differs_where", index::binary32::shipped_published());
  add("tree/all_levels", tree::induction::shipped_all_levels());
  add("dag/all_levels", dag::induction::shipped_all_levels());
  add("attribute/w_minor_all_levels", attribute::induction::shipped_w_minor());
  add("attribute/u_major_all_levels", attribute::induction::shipped_u_major());
  add("attribute/bird_all_levels", attribute::induction::shipped_bird());
  add("attribute/faces_all_levels", attribute::induction::shipped_faces());
  return all;
}

}  // namespace mmverify::proofs
