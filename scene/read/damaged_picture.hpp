// A fault in the bytes of a picture.
#pragma once

#include <stdexcept>
#include <string>

namespace mmverify::scene {

/// A fault that a decoder found: the decoder's caller adds the file and the place.
struct DamagedPicture : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Calls read(), and puts the part's name before a fault: "the endpoint codebook: its bits end early".
template <class Read>
auto in_part(const char* part, Read read) {
  try {
    return read();
  } catch (const DamagedPicture& damage) {
    throw DamagedPicture(std::string(part) + ": " + damage.what());
  }
}

}  // namespace mmverify::scene
