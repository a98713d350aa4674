// bench --subject: the cost of judging a shared library, compared with calling it.
#pragma once

#include <string>

#include "bench/subject/tables.hpp"

namespace mmverify::cli {

/// Measures one library at a level. EnvironmentError if it is no subject.
bench::SubjectFigures subject_figures(const std::string& library, std::uint32_t level);

}  // namespace mmverify::cli
