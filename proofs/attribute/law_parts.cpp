#include "proofs/attribute/law_parts.hpp"

namespace mmverify::proofs::attribute {

Lacks needing(std::vector<Entry> entries) {
  return [lacks = lacking<AttributeSubject>(std::move(entries))](const AttributeSubject& s) {
    return lacks(s, 0);
  };
}

Unfit unfit_by(Lacks lacks) {
  return unless_of_topic<AttributeSubject>(
      [lacks = std::move(lacks)](const AttributeSubject& s, Level n) -> std::optional<std::string> {
        if (auto why = lacks(s)) return why;
        return above_its_levels(s, n);
      });
}

}  // namespace mmverify::proofs::attribute
