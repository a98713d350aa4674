// The cost to judge a shared library, beside the cost to call it.
#pragma once

#include <cstdint>
#include <string>

#include "bench/result.hpp"

namespace mmverify::bench {

struct SubjectFigures {
  std::string library;
  std::uint32_t level = 0;
  std::uint64_t batch = 0;  ///< indices a call
  double bare_ns = 0,
         isolated_ns = 0;     ///< an index: in a loop in this process, and in a worker process
  double isolated_ratio = 0;  ///< isolated / bare: the median of the rounds' ratios
  double judged_ns = 0;       ///< a cell of index.equals_reference
  std::string verdict;        ///< of that law at this level
};

Result subject_tables(const SubjectFigures& figures);

}  // namespace mmverify::bench
