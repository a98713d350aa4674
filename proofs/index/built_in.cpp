#include "proofs/index/built_in.hpp"

#include "proofs/index/algorithms.hpp"
#include "proofs/index/exact_subject.hpp"
#include "proofs/index/reference_sweep.hpp"
#include "proofs/index/rounded_subject.hpp"
#include "proofs/index/step_sweep.hpp"

namespace mmverify::proofs::index {
namespace {

using impl::Binary16;
using spec::index::Reading;
using Printed = StepAlgorithm<Reading::printed>;

// 2^16 overflows binary16.
constexpr Level binary16_levels = 15;

/// Algorithm 4 as printed; whole rows go through step_row.
class StepSubject : public ExactSubject<Printed> {
 public:
  using ExactSubject<Printed>::ExactSubject;
  using ExactSubject<Printed>::index;
  void index(Level n, Batch batch, std::span<std::uint32_t> out) const override {
    if (batch.row && !batch.points.empty())
      step_row(n, batch.points.front(), batch.points.back(), out);
    else
      ExactSubject<Printed>::index(n, batch, out);
  }
  void index_rows(Level n, Level grid, std::span<const Row> rows,
                  std::span<std::uint32_t> out) const override {
    for (const Row& row : rows) {
      step_row(n, representative(row, 0, grid), representative(row, row.count - 1, grid),
               out.first(row.count));
      out = out.subspan(row.count);
    }
  }
};

/// The Vulkan formula; rows go through reference_rows.
class ReferenceSubject : public ExactSubject<ReferenceAlgorithm> {
 public:
  using ExactSubject<ReferenceAlgorithm>::ExactSubject;
  void index_rows(Level n, Level grid, std::span<const Row> rows,
                  std::span<std::uint32_t> out) const override {
    reference_rows(n, grid, rows, out);
  }
};

class GivenAnswer : public IndexSubject {
 public:
  explicit GivenAnswer(std::uint32_t answer)
      : IndexSubject("the answer given", "one answer", Arithmetic::exact, 16), answer_(answer) {}
  bool has(Entry e) const override { return e == Entry::index; }
  std::uint32_t index(Level, const RationalPoint&) const override { return answer_; }

 private:
  std::uint32_t answer_;
};

template <class S, class... Args>
std::shared_ptr<const IndexSubject> make(Args&&... args) {
  return std::make_shared<S>(std::forward<Args>(args)...);
}

std::vector<std::shared_ptr<const IndexSubject>> make_all() {
  std::vector<std::shared_ptr<const IndexSubject>> all{
      make<ReferenceSubject>("reference", "the Vulkan bit formula, 32-bit words, exact"),
      make<ExactSubject<WideAlgorithm>>("reference-wide", "the same formula, 64-bit words, exact"),
      make<StepSubject>("step", "Algorithm 4 as printed, exact"),
      make<ExactSubject<StepAlgorithm<Reading::appendix_middle>>>(
          "step-appendix-middle", "Algorithm 4, the middle triangle's coordinates in Appendix A's order"),
      make<ExactSubject<StepAlgorithm<Reading::appendix_ties>>>(
          "step-appendix-ties", "Algorithm 4, the R test's exception on u as Appendix A's prose has it"),
      make<ExactSubject<StepAlgorithm<Reading::appendix_names>>>(
          "step-appendix-names", "Algorithm 4, the coordinates that Appendix A gives under L, R and T"),
      make<RoundedSubject<ReferenceAlgorithm, Binary16>>("reference-f16", "the Vulkan formula in binary16",
                                                         binary16_levels),
      make<RoundedSubject<ReferenceAlgorithm, float>>("reference-f32", "the Vulkan formula in binary32"),
      make<RoundedSubject<ReferenceAlgorithm, double>>("reference-f64", "the Vulkan formula in binary64"),
      make<RoundedSubject<Printed, Binary16>>("step-f16", "Algorithm 4 in binary16", binary16_levels),
      make<RoundedSubject<Printed, float>>("step-f32", "Algorithm 4 in binary32"),
      make<RoundedSubject<Printed, double>>("step-f64", "Algorithm 4 in binary64"),
      impl_subject(),
  };
  for (auto& rows : row_subjects()) all.push_back(rows);
  return all;
}

}  // namespace

std::shared_ptr<const IndexSubject> given_answer(std::uint32_t answer) {
  return std::make_shared<GivenAnswer>(answer);
}

const std::vector<std::shared_ptr<const IndexSubject>>& built_in_subjects() {
  static const auto all = make_all();
  return all;
}

std::shared_ptr<const IndexSubject> built_in_subject(const std::string& name) {
  for (const auto& s : built_in_subjects())
    if (s->name() == name) return s;
  return nullptr;
}

}  // namespace mmverify::proofs::index
