#include "proofs/attribute/law_parts.hpp"

namespace mmverify::proofs::attribute {

const AttributeSubject& of_attribute(const Subject& s) { return dynamic_cast<const AttributeSubject&>(s); }

Lacks needing(std::vector<Entry> entries) {
  return [entries = std::move(entries)](const AttributeSubject& s) -> std::optional<std::string> {
    for (const Entry& e : entries)
      if (!e.there(s.functions)) return fmt::format("{} has no entry point {}", s.name(), e.name);
    return std::nullopt;
  };
}

std::function<std::optional<std::string>(const Subject&, Level)> unfit_by(Lacks lacks) {
  return [lacks = std::move(lacks)](const Subject& subject, Level n) -> std::optional<std::string> {
    const auto* s = dynamic_cast<const AttributeSubject*>(&subject);
    if (s == nullptr) return "not a subject of topic attribute";
    if (auto why = lacks(*s)) return why;
    if (const Level last = s->functions.max_level; n > last)
      return fmt::format("{} is defined up to level {}", s->name(), last);
    return std::nullopt;
  };
}

}  // namespace mmverify::proofs::attribute
