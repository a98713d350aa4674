#include "proofs/traverse/subject.hpp"

#include <map>
#include <stdexcept>
#include <tuple>

#include "impl/traverse/decision.hpp"
#include "proofs/traverse/combinations.hpp"
#include "proofs/traverse/words.hpp"

namespace mmverify::proofs::traverse {
namespace {

namespace fast = mmverify::impl::traverse;
namespace slow = mmverify::spec::traverse;

Functions specified() {
  Functions f;
  f.decide = slow::decide;
  f.undefined = slow::undefined;
  return f;
}

Undefined reasons(const Combination& c) {
  const Words w = words_of(c);
  const std::uint32_t set = fast::undefined(c.enabled, w.candidate, w.instance, w.ray);
  return {(set & fast::undefined_ray_flags) != 0, (set & fast::undefined_instance_flags) != 0,
          (set & fast::undefined_not_enabled) != 0};
}

Functions singles() {
  Functions f;
  f.decide = [](const Combination& c) {
    const Words w = words_of(c);
    return static_cast<Outcome>(fast::decide(w.candidate, w.instance, w.ray));
  };
  f.undefined = reasons;
  return f;
}

/// The spans' answers to all combinations that are defined, asked for at once.
class Batch {
 public:
  Batch() {
    std::vector<std::uint32_t> candidate, instance, ray;
    for (const Combination& c : defined()) {
      const Words w = words_of(c);
      candidate.push_back(w.candidate);
      instance.push_back(w.instance);
      ray.push_back(w.ray);
    }
    std::vector<fast::Outcome> out(candidate.size());
    fast::decide(candidate, instance, ray, out);
    for (std::size_t k = 0; k < out.size(); ++k)
      answers_[{candidate[k], instance[k], ray[k]}] = static_cast<Outcome>(out[k]);
  }
  Outcome operator()(const Combination& c) const {
    const Words w = words_of(c);
    return answers_.at({w.candidate, w.instance, w.ray});
  }

 private:
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, Outcome> answers_;
};

Functions spans() {
  Functions f = singles();
  f.decide = [batch = std::make_shared<const Batch>()](const Combination& c) { return (*batch)(c); };
  return f;
}

TraverseSubjectPtr subject(const char* name, const char* about, Functions functions) {
  return std::make_shared<TraverseSubject>(name, about, std::move(functions));
}

}  // namespace

const std::vector<TraverseSubjectPtr>& built_in_subjects() {
  static const std::vector<TraverseSubjectPtr> all{
      subject("traverse-spec", "the specification, step by step", specified()),
      subject("traverse", "impl/traverse: words of flags, many at once", spans()),
      subject("traverse-single", "impl/traverse: one at a time", singles())};
  return all;
}

TraverseSubjectPtr built_in(const std::string& name) {
  for (const TraverseSubjectPtr& s : built_in_subjects())
    if (s->name() == name) return s;
  throw std::logic_error("no built-in subject of topic traverse named " + name);
}

Mutant mutant(const char* name, const std::string& base, const std::function<void(Functions&)>& change) {
  Functions functions = built_in(base)->functions;
  change(functions);
  return {name, std::make_shared<TraverseSubject>(name, "broken on purpose", std::move(functions)), {0, 0}};
}

}  // namespace mmverify::proofs::traverse
