// The readers of a file's views and accessors, other than micromaps.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace mmverify::scene {

/// The reader of a view that is no micromap: "accessor 0's", "image 2's"; empty if there is none.
std::string other_reader_of_view(const nlohmann::json& document, std::size_t view);

/// The part of the geometry that reads an accessor: "the POSITION of mesh 0 primitive 1"; empty if there is none.
std::string other_reader_of_accessor(const nlohmann::json& document, std::size_t accessor);

}  // namespace mmverify::scene
