// bench --subject: what judging a shared library costs beside calling it.
#pragma once

#include <string>

#include "bench/subject/tables.hpp"

namespace mmverify::cli {

/// Measures one library at a level.  EnvironmentError where it is no subject.
bench::SubjectFigures subject_figures(const std::string& library, std::uint32_t level);

}  // namespace mmverify::cli
