// The message of a refused call.
#pragma once

#include <exception>
#include <string>

namespace mmverify::tests {

/// The message of the Error that ends the call; `none` if none does.
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
