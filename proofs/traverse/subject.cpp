#include "proofs/traverse/subject.hpp"

#include "impl/traverse/blend.hpp"
#include "impl/traverse/decision.hpp"
#include "proofs/traverse/colours.hpp"
#include "proofs/traverse/combinations.hpp"
#include "proofs/traverse/rays/sample_world.hpp"

namespace mmverify::proofs::traverse {
namespace {

namespace fast = mmverify::impl::traverse;
namespace slow = mmverify::spec::traverse;

Functions specified() {
  Functions f;
  f.decide = slow::decide;
  f.undefined = slow::undefined;
  f.blend = [](Operation o, std::span<const std::uint32_t> payload, std::span<const std::uint32_t> value,
               std::span<std::uint32_t> out) {
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = word_of(slow::blend(o, colour_of(payload[k]), colour_of(value[k])));
  };
  f.gather = slow::blended_before_closest;
  return f;
}

Functions as_met() {
  Functions f;
  f.gather = slow::blended_as_met;
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
  f.blend = [](Operation o, std::span<const std::uint32_t> payload, std::span<const std::uint32_t> value,
               std::span<std::uint32_t> out) {
    for (std::size_t k = 0; k < out.size(); ++k)
      out[k] = fast::blend(static_cast<fast::Operation>(o), payload[k], value[k]);
  };
  f.gather = [](Operation o, const slow::Colour& payload, std::span<const Hit> hits) {
    std::vector<fast::Hit> all;
    for (const Hit& h : hits) all.push_back({number_of_distance(h.distance), h.accepted, word_of(h.value)});
    return colour_of(fast::blended(static_cast<fast::Operation>(o), word_of(payload), all));
  };
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

std::optional<State> look(const Looks& asks) {
  const auto state =
      SampleWorld::get().opacity(asks.method, asks.level)->at(asks.geometry, asks.triangle, asks.at);
  return state ? std::optional(static_cast<State>(*state)) : std::nullopt;
}

Functions spans() {
  Functions f = singles();
  f.look = look;
  f.decide = [batch = std::make_shared<const Batch>()](const Combination& c) { return (*batch)(c); };
  f.blend = [](Operation o, std::span<const std::uint32_t> payload, std::span<const std::uint32_t> value,
               std::span<std::uint32_t> out) {
    fast::blend(static_cast<fast::Operation>(o), payload, value, out);
  };
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
      subject("traverse-single", "impl/traverse: one at a time", singles()),
      subject("traverse-as-met", "blends hits as it meets them, accepted ones behind them or not", as_met())};
  return all;
}

}  // namespace mmverify::proofs::traverse
