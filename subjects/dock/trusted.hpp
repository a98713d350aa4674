// A library in this process, to measure its own calls: without a worker's walls.
#pragma once

#include <string>

#include "subjects/dock/worker.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::dock {

/// The subject of a library, which stays loaded.  A worker loads it first, so only a subject comes into this process; a
/// fault of its later calls ends the program.  Throws CannotLoad.
const mmverify_subject_t& load_trusted(const std::string& library, const Options& options);

}  // namespace mmverify::dock
