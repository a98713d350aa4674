// What a page shows of refuted laws and no result file has: the answers of built-in subjects, asked again.
#pragma once

#include "cli/report_input.hpp"

namespace mmverify::cli {

/// "asked": subjects of topic index, where they are wrong on the cells of some levels; "again": for each
/// refuted result what came of asking once more, or why nobody was asked.  Only built-in subjects are: no
/// library is started for a page.
nlohmann::ordered_json asked_again(const std::vector<ReportInput>& inputs);

}  // namespace mmverify::cli
