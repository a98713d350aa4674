// What is said of an access or a pointer that is undefined, or that is not judged.
#pragma once

#include "source/reader/undefined.hpp"

namespace mmverify::source {

const char* said(Outside what);
const char* said(Refusal why);

}  // namespace mmverify::source
