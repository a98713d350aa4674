#include "proofs/subdivision/subject.hpp"

#include "impl/subdivision/subdivision.hpp"
#include "proofs/subdivision/cases.hpp"
#include "spec/rational.hpp"

namespace mmverify::proofs::subdivision {
namespace {

namespace fast = impl::subdivision;
using spec::Rational;

fast::Scheme of_library(Scheme scheme) { return static_cast<fast::Scheme>(scheme); }

Functions specified() {
  Functions f;
  f.index = [](Scheme scheme, Level n, const Fractions& p) { return specified_index(scheme, n, p); };
  f.corners = [](Scheme scheme, Level n, std::uint64_t k) {
    return spec::subdivision::cell<Whole>(scheme, n, k, side(scheme, n)).corners;
  };
  f.shapes = spec::subdivision::shapes;
  return f;
}

Functions rational() {
  Functions f;
  f.max_level = 2;
  f.index = [](Scheme scheme, Level n, const Fractions& p) {
    const auto coordinate = [&](std::size_t k) {
      return Rational(p.numerators[k]) / Rational(p.denominator);
    };
    return spec::subdivision::index<Rational>(scheme, n, {coordinate(0), coordinate(1), coordinate(2)},
                                              Rational(1));
  };
  return f;
}

Functions of_this_library() {
  Functions f;
  f.index = [](Scheme scheme, Level n, const Fractions& p) -> std::uint64_t {
    return fast::index(of_library(scheme), n, {p.numerators, p.denominator});
  };
  f.corners = [](Scheme scheme, Level n, std::uint64_t k) {
    const fast::Corners found = fast::corners(of_library(scheme), n, static_cast<std::uint32_t>(k));
    Corners<Whole> corners{};
    for (std::size_t c = 0; c < corners.size(); ++c)
      for (std::size_t axis = 0; axis < 3; ++axis) corners[c][axis] = found[c][axis];
    return corners;
  };
  f.machine = [](Scheme scheme) {
    Machine machine;
    for (const fast::detail::Orientation& o : fast::detail::orientations(of_library(scheme))) {
      Orientation one{{}, o.scale, {}, {}};
      for (std::size_t c = 0; c < one.corners.size(); ++c)
        for (std::size_t axis = 0; axis < 3; ++axis) one.corners[c][axis] = o.corners[c][axis];
      for (std::size_t digit = 0; digit < cut(scheme).children; ++digit) {
        one.shift.push_back({o.shift[digit][0], o.shift[digit][1], o.shift[digit][2]});
        one.next.push_back(o.next[digit]);
      }
      machine.push_back(std::move(one));
    }
    return machine;
  };
  return f;
}

SubdivisionSubjectPtr subject(const char* name, const char* about, Functions functions) {
  return std::make_shared<SubdivisionSubject>(name, about, std::move(functions));
}

}  // namespace

const std::vector<SubdivisionSubjectPtr>& built_in_subjects() {
  static const std::vector<SubdivisionSubjectPtr> all{
      subject("subdivision-spec", "the specification, on whole numbers", specified()),
      subject("subdivision-rational", "the specification, on rationals", rational()),
      subject("subdivision", "this project's library", of_this_library())};
  return all;
}

}  // namespace mmverify::proofs::subdivision
