// SHA-256 (FIPS 180-4), the identity of a module.
#pragma once

#include <string>
#include <string_view>

namespace mmverify::shaders {

/// 64 hexadecimal digits, as sha256sum prints them.
std::string sha256(std::string_view bytes);

}  // namespace mmverify::shaders
