#include "delivery/gate/seal.hpp"

#include <fmt/format.h>

#include <boost/crc.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace mmverify::gate {
namespace {

using Json = nlohmann::ordered_json;
using Crc64 =
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693u, 0xFFFFFFFFFFFFFFFFu, 0xFFFFFFFFFFFFFFFFu, true, true>;

}  // namespace

std::string seal_of(const Json& run) {
  Json rest = run;
  rest.erase("seal");
  const std::string text = rest.dump(-1, ' ', false, Json::error_handler_t::replace);
  Crc64 crc;
  crc.process_bytes(text.data(), text.size());
  return fmt::format("{:016x}", std::uint64_t{crc.checksum()});
}

bool is_sealed(const Json& run) {
  return run.is_object() && run.contains("seal") && run.at("seal") == seal_of(run);
}

}  // namespace mmverify::gate
