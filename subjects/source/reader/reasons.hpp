// Reasons, in words: why an access or a pointer is undefined, or is not judged.
#pragma once

#include "subjects/source/reader/undefined.hpp"

namespace mmverify::source {

const char* said(Outside what);
const char* said(Refusal why);

}  // namespace mmverify::source
