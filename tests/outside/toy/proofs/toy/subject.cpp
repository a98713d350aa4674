#include "proofs/toy/subject.hpp"

#include "impl/toy/twice.hpp"

namespace mmverify::proofs::toy {

const std::vector<ToySubjectPtr>& built_in_subjects() {
  static const std::vector<ToySubjectPtr> all{
      std::make_shared<ToySubject>("toy", "the library", Functions{impl::toy::twice})};
  return all;
}

}  // namespace mmverify::proofs::toy
