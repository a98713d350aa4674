// A right function for every entry point of the table.
#pragma once

#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::independence {

/// All entry points are there.
mmverify_subject_t right_of_all();

}  // namespace mmverify::independence
