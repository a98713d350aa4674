#include "proofs/attribute/subject.hpp"

#include <stdexcept>

#include "proofs/attribute/subject_parts.hpp"

namespace mmverify::proofs::attribute {
namespace {

AttributeSubjectPtr subject(const char* name, const char* about, const Functions& functions) {
  return std::make_shared<AttributeSubject>(name, about, functions);
}

/// Each part of the topic has its line here.
AttributeSubjectPtr specified() {
  Functions f;
  f.orders = specified_orders();
  f.baking = specified_baking();
  return subject("attribute-spec", "the specification, in whole numbers and rationals", f);
}

AttributeSubjectPtr library() {
  Functions f;
  f.exact = false;
  f.baking = library_baking();
  return subject("attribute", "this project's library, in batches and binary32", f);
}

}  // namespace

const std::vector<AttributeSubjectPtr>& built_in_subjects() {
  static const std::vector<AttributeSubjectPtr> all{specified(), library()};
  return all;
}

AttributeSubjectPtr built_in(const std::string& name) {
  for (const AttributeSubjectPtr& s : built_in_subjects())
    if (s->name() == name) return s;
  throw std::logic_error("no subject of topic attribute is called " + name);
}

Mutant mutant(const char* name, const std::string& base, Levels levels,
              const std::function<void(Functions&)>& change) {
  Functions functions = built_in(base)->functions;
  change(functions);
  return {name, std::make_shared<AttributeSubject>(name, "broken on purpose", std::move(functions)), levels};
}

}  // namespace mmverify::proofs::attribute
