// Repeats the questions of counterexamples to built-in subjects, for a page: the result files do not have the
// answers.
#pragma once

#include "cli/report/input.hpp"

namespace mmverify::cli {

/// "asked": for subjects of topic index, the cells of some levels with wrong answers; "again": for each
/// refuted result the outcome of asking again, or the reason why it was not asked. Only built-in subjects are
/// asked: no library is started for a page.
nlohmann::ordered_json asked_again(const std::vector<ReportInput>& inputs);

}  // namespace mmverify::cli
