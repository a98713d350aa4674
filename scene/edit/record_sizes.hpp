// Levels and formats of records, by the bytes that lie between a map and the next one.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "impl/micromap/array.hpp"

namespace mmverify::scene {

/// The records with other levels and formats where a record's do not fill the bytes up to the next record's first, or to
/// the end of the data.  Nothing if some of these sizes is of no map, or of several, or the first map is not at byte 0.
/// Domain: records of one micromap; levels and formats are any numbers.
/// Test: RecordSizes (edit_test).
std::optional<std::vector<impl::micromap::Record>> sized_by_gaps(std::vector<impl::micromap::Record> records,
                                                                 std::uint64_t data_bytes);

}  // namespace mmverify::scene
