// The elements on which a library's entry points crashed or hung; they are not asked again.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>

#include "subjects/dock/worker.hpp"

namespace mmverify::dock {

/// A command to a worker on the elements in its inputs.
struct Command {
  Call call;
  std::uint32_t level, format;
  std::uint64_t count;
};

/// The known breaks of one library. Thread-safe.
class KnownBreaks {
 public:
  struct Break {
    std::string what;  ///< what the library did
    bool hung = false;
  };
  struct BrokenElement {
    std::uint64_t element;
    Break known;
  };

  /// Records that element t of the command in the worker's inputs makes the library do `what`.
  void add(const Worker& worker, const Command& command, std::uint64_t t, const Break& what);

  /// The first element of the command in the worker's inputs with a known break.
  std::optional<BrokenElement> first(const Worker& worker, const Command& command) const;

 private:
  using Inputs = std::string;  ///< an element's bytes, array after array
  mutable std::mutex lock_;
  std::map<std::tuple<Call, std::uint32_t, std::uint32_t>, std::map<Inputs, Break>>
      known_;  ///< by call, level and format
};

}  // namespace mmverify::dock
