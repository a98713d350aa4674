// Earlier questions, and memory of earlier calls, that later ones are asked beside or after.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "subjects/dock/desk/lent.hpp"
#include "subjects/dock/desk/questions.hpp"

namespace mmverify::dock {

struct WorkerMemory {
  /// The first batch of a level.
  struct Batch {
    std::uint32_t level = 0;
    std::vector<std::byte> arrays[most_arrays];
  };
  std::uint64_t levels[calls][formats] = {};  ///< bit n: the entry point was called at level n
  std::optional<Batch> level_before[calls][formats];
  /// Questions on blobs by entry point, level and format: the first ones, and the last one.
  std::map<std::array<std::uint32_t, 3>, std::deque<QuestionCopy>> of_format;
  std::optional<QuestionCopy> last[calls];         ///< the last one that two threads asked
  std::deque<QuestionCopy> of_other_kinds[calls];  ///< questions at other levels and in other formats
  bool elsewhere_first[calls] = {};  ///< the last question's first call had the copy of its blob
  std::vector<std::byte> elsewhere;  ///< that copy
  std::vector<std::byte> arrays_elsewhere[most_arrays];  ///< the copies of a lookup's arrays
  std::unique_ptr<Lent> lent;                            ///< the last call's memory
};

}  // namespace mmverify::dock
