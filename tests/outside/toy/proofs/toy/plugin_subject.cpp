#include "proofs/toy/plugin_subject.hpp"

#include "subjects/dock/elements.hpp"

namespace mmverify::proofs::toy {

ToySubjectPtr plugin_subject(const std::string& name, const dock::LibraryPtr& library) {
  if (!library->offers(dock::Topic::toy)) return nullptr;
  Functions f;
  f.twice = [library](std::uint32_t k) {
    std::uint32_t out = 0;
    dock::ask_all(*library,
                  {dock::Call::toy_twice, 0, 0, {&k}, [&](std::size_t) { return std::to_string(k); }}, 1,
                  &out);
    return out;
  };
  return std::make_shared<ToySubject>(name, library->about(), std::move(f), library->fingerprint());
}

}  // namespace mmverify::proofs::toy
