#include "proofs/traverse/laws.hpp"

#include "proofs/engine/spoils.hpp"
#include "proofs/traverse/law_parts.hpp"

namespace mmverify::proofs::traverse {

std::vector<Law> laws() {
  std::vector<Law> all;
  for (const auto& group : {decision_laws(), lossy_laws(), blend_laws(), blend_sample_laws(), order_laws(),
                            many_hits_laws(), image_laws(), payload_laws()})
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

Unfit needing(std::vector<Entry> entries) {
  return unless_of_topic<TraverseSubject>(lacking<TraverseSubject>(std::move(entries)));
}

std::function<void(Functions&)> deciding(Outcome (*wrong)(const Combination&, Outcome)) {
  return spoils(&Functions::decide, [wrong](const Combination& c, Outcome& o) { o = wrong(c, o); });
}

std::function<void(Functions&)> mistaking(void (*change)(Combination&)) {
  return [change](Functions& f) {
    f.decide = [change, real = f.decide](Combination c) {
      change(c);
      return real(c);
    };
  };
}

std::function<void(Functions&)> gathering(void (*change)(std::vector<Hit>&)) {
  return [change](Functions& f) {
    f.gather = [change, real = f.gather](Operation o, const spec::traverse::Colour& payload,
                                         std::span<const Hit> hits) {
      std::vector<Hit> others(hits.begin(), hits.end());
      change(others);
      return real(o, payload, others);
    };
  };
}

std::string text_of_colour(const spec::traverse::Colour& c) {
  return fmt::format("{} {} {} {}", c[0], c[1], c[2], c[3]);
}

std::string text_of(Outcome o) {
  return o <= Outcome::non_opaque ? name_of(o) : fmt::format("outcome {}", static_cast<unsigned>(o));
}

Finding same(Outcome expected, Outcome got) {
  if (got == expected) return {static_cast<std::uint64_t>(got) + 1};
  return wrong(text_of(expected), text_of(got));
}

Law on_defined(Law law, bool (*about)(const Combination&), Check check) {
  const auto some = std::make_shared<std::vector<Combination>>();
  std::copy_if(defined().begin(), defined().end(), std::back_inserter(*some), about);
  Cases<Combination> cases;
  cases.count = [some] { return std::uint64_t{some->size()}; };
  cases.number = [some](std::uint64_t k) { return (*some)[k]; };
  cases.text = [](const Combination& c) { return text_of(c); };
  cases.read = [about, id = law.id](const std::string& at) {
    const Combination c = combination_of(at);
    if (undefined(c).any()) throw BadCase(fmt::format("'{:.100}': no API defines the outcome", at));
    if (!about(c)) throw BadCase(fmt::format("'{:.100}': {} is about others", at, id));
    return c;
  };
  cases.check = std::move(check);
  return on_cases(std::move(law), {entry::decide}, std::move(cases));
}

}  // namespace mmverify::proofs::traverse
