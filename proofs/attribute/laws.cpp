#include "proofs/attribute/laws.hpp"

#include "proofs/attribute/induction/provable.hpp"
#include "proofs/attribute/law_parts.hpp"

namespace mmverify::proofs::attribute {

std::vector<Law> laws() {
  std::vector<Law> all;
  for (const auto& group : {order_laws(), induction::laws(), lookup_laws(), decimation_laws(), mip_laws(),
                            bake_laws(), compression_laws(), paper_laws()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

std::vector<Law> paper_laws() {
  std::vector<Law> all;
  for (const auto& group :
       {order_paper_laws(), lookup_paper_laws(), decimation_paper_laws(), mip_paper_laws()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

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
