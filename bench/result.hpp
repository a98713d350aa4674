// The result of a bench.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/picture.hpp"
#include "bench/table.hpp"

namespace mmverify::bench {

struct Result {
  std::string topic;
  std::vector<std::pair<std::string, Value>> settings;  ///< of the run, by their names in JSON's "tool"
  std::string about;                                    ///< printed above the tables
  std::vector<Table> tables;
  std::optional<picture::Picture> drawn = {};  ///< none: these figures are not drawn
};

}  // namespace mmverify::bench
