// The result of a bench.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/picture.hpp"
#include "bench/table.hpp"

namespace mmverify::bench {

struct Setting {
  Property key;  ///< in JSON's "tool"
  Value value;
};

struct Result {
  std::string topic;
  std::string description = {};   ///< of its JSON
  std::vector<Setting> settings;  ///< of the run
  std::string about;              ///< printed above the tables
  std::vector<Table> tables;
  std::optional<picture::Picture> drawn = {};  ///< none: these figures are not drawn
};

}  // namespace mmverify::bench
