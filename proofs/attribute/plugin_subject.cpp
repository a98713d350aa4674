#include "proofs/attribute/plugin_subject.hpp"

namespace mmverify::proofs::attribute {

AttributeSubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library) {
  if (!library->offers(dock::Topic::attribute)) return nullptr;
  Functions functions;
  functions.exact = false;
  functions.max_level = library->description().max_level;
  return std::make_shared<AttributeSubject>(name, library->about(), std::move(functions),
                                            library->fingerprint());
}

}  // namespace mmverify::proofs::attribute
