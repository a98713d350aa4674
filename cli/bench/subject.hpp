// bench subject: what judging a shared library costs beside calling it.
#pragma once

#include <cstdio>
#include <string>

namespace mmverify::cli {

/// Prints the figures of one library at a level; returns them as JSON text.  EnvironmentError where it is no
/// subject.
std::string bench_subject(const std::string& library, std::uint32_t level, std::FILE* out);

}  // namespace mmverify::cli
