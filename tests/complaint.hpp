// What a call is refused with.
#pragma once

#include <exception>
#include <string>

namespace mmverify::tests {

/// What the exception says that ends the call, an Error; `none` where it ends without.
template <class Error = std::exception, class Call>
std::string complaint_of(Call call, const std::string& none = "none") {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return none;
}

}  // namespace mmverify::tests
