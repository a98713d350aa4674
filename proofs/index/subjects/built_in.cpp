#include "proofs/engine/shape.hpp"
#include "proofs/index/grid/reference_sweep.hpp"
#include "proofs/index/subjects/algorithms.hpp"
#include "proofs/index/subjects/exact_subject.hpp"
#include "proofs/index/subjects/rounded_subject.hpp"

namespace mmverify::proofs::index {
namespace {

using impl::Binary16;
using spec::index::Reading;
using Printed = StepAlgorithm<Reading::printed>;

// 2^16 overflows binary16.
constexpr Level binary16_levels = 15;

/// Algorithm 4 as printed; whole rows go through step_row.
Functions step() {
  Functions f = exactly<Printed>();
  f.index = [one_by_one = f.index](Level n, Batch batch, std::span<std::uint32_t> out) {
    if (batch.row && !batch.points.empty())
      step_row(n, batch.points.front(), batch.points.back(), out);
    else
      one_by_one(n, batch, out);
  };
  f.index_rows = [](Level n, Level grid, std::span<const Row> rows, std::span<std::uint32_t> out) {
    for (const Row& row : rows) {
      step_row(n, representative(row, 0, grid), representative(row, row.count - 1, grid),
               out.first(row.count));
      out = out.subspan(row.count);
    }
  };
  return f;
}

/// The Vulkan formula; rows go through reference_rows.
Functions reference() {
  Functions f = exactly<ReferenceAlgorithm>();
  f.index_rows = reference_rows;
  return f;
}

IndexSubjectPtr subject(const char* name, const char* about, Functions functions) {
  return std::make_shared<IndexSubject>(name, about, std::move(functions));
}

std::vector<IndexSubjectPtr> make_all() {
  std::vector<IndexSubjectPtr> all{
      subject("reference", "the Vulkan bit formula, 32-bit words, exact", reference()),
      subject("reference-wide", "the same formula, 64-bit words, exact", exactly<WideAlgorithm>()),
      subject("vulkan-prose",
              "Vulkan's chapter on ray traversal read to the letter, u and v scaled by 2^n, exact",
              exactly<ProseAlgorithm>()),
      subject("step", "Algorithm 4 as printed, exact", step()),
      subject("step-appendix-middle", "Algorithm 4, the middle triangle's coordinates in Appendix A's order",
              exactly<StepAlgorithm<Reading::appendix_middle>>()),
      subject("step-appendix-ties", "Algorithm 4, the R test's exception on u as Appendix A's prose has it",
              exactly<StepAlgorithm<Reading::appendix_ties>>()),
      subject("step-appendix-names", "Algorithm 4, the coordinates that Appendix A gives under L, R and T",
              exactly<StepAlgorithm<Reading::appendix_names>>()),
      subject("step-restarted", "Algorithm 4 begun anew for each digit, as Algorithm 3 calls it",
              exactly<StepAlgorithm<Reading::restarted>>()),
      subject("reference-f16", "the Vulkan formula in binary16",
              roundedly<ReferenceAlgorithm, Binary16>(binary16_levels)),
      subject("reference-f32", "the Vulkan formula in binary32", roundedly<ReferenceAlgorithm, float>()),
      subject("reference-f64", "the Vulkan formula in binary64", roundedly<ReferenceAlgorithm, double>()),
      subject("step-f16", "Algorithm 4 in binary16", roundedly<Printed, Binary16>(binary16_levels)),
      subject("step-f32", "Algorithm 4 in binary32", roundedly<Printed, float>()),
      subject("step-f64", "Algorithm 4 in binary64", roundedly<Printed, double>()),
      impl_subject(),
  };
  for (auto& rows : row_subjects()) all.push_back(rows);
  return all;
}

}  // namespace

IndexSubjectPtr given_answer(const std::string& answer) {
  Functions f;
  const auto number = [](const std::string& digits) {
    const std::uint64_t value = std::stoull(digits);
    if (value >> 32 != 0) throw BadCase(fmt::format("'{}': no answer has more than 32 bits", digits));
    return static_cast<std::uint32_t>(value);
  };
  constexpr char corner[] = R"(\(([0-9]{1,10}),([0-9]{1,10})\))";
  if (groups_of(answer, "[0-9]{1,10}")) {
    f.index_at = [index = number(answer)](Level, const RationalPoint&) { return index; };
  } else if (const Groups c = groups_of(answer, fmt::format("{0} {0} {0}", corner).c_str())) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = {number((*c)[1 + 2 * k]), number((*c)[2 + 2 * k])};
    f.corners = [corners](Level, std::span<const std::uint32_t>, std::span<Corners> out) {
      std::fill(out.begin(), out.end(), corners);
    };
  } else {
    throw BadCase(fmt::format("'{:.60}': write an index, or three corners as '(0,0) (1,0) (0,1)'", answer));
  }
  return subject("the answer given", "one answer", std::move(f));
}

const std::vector<IndexSubjectPtr>& built_in_subjects() {
  static const auto all = make_all();
  return all;
}

}  // namespace mmverify::proofs::index
