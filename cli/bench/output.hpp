// What the bench of a topic leaves besides its printed tables.
#pragma once

#include <string>

namespace mmverify::cli {

struct BenchOutput {
  std::string json;  ///< as JSON text
  std::string plot;  ///< as a gnuplot script
};

}  // namespace mmverify::cli
