// The rows of the short answer: a law on a subject, its levels merged.
#pragma once

#include <string>
#include <vector>

#include "proofs/engine/runner.hpp"

namespace mmverify::cli {

/// The results of one law on one subject.
struct Row {
  const proofs::Result* first;  ///< of all its results
  std::vector<const proofs::Result*>
      judged;               ///< the results at levels where the law applies, from the lowest on
  proofs::Verdict verdict;  ///< the weakest of `judged`; not_applicable if there is none

  /// Whether its verdict asks for work: broken, refuted or incomplete.
  bool is_fault() const;
};

/// The rows of a report, in the order of its results. They point into the report.
std::vector<Row> rows_of(const proofs::Report& report);

/// "levels 0..2": the levels with the row's verdict, and of which ones: "level 2 of 0..2".
std::string levels_of(const Row& row);

/// The row as a line: verdict, law, subject if `name_subject`, levels, cases.
std::string row_line(const Row& row, bool name_subject);

/// "4 laws refuted, 5 proved, 2 checked": the rows that judged something, counted by the weakest verdict of each law.
std::string count_of_laws(const std::vector<Row>& rows);

/// The topics of rows without a fault, a line each: laws, subjects and cases counted.
std::vector<std::string> topic_lines(const std::vector<Row>& rows);

}  // namespace mmverify::cli
