// Mutations of a scene_input.hpp that keep its JSON valid: one value becomes a wrong number, another type, or
// a copy of another value, or is removed.  libFuzzer mutates the bytes of the BIN chunk, and every fourth
// input as a whole.
#include <nlohmann/json.hpp>
#include <random>

#include "fuzz/scene_input.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using Json = nlohmann::json;
using Random = std::minstd_rand;

std::size_t below(std::size_t end, Random& random) { return random() % end; }

/// Collects all values in one list, the root first.
void collect(Json& json, std::vector<Json*>& all) {
  all.push_back(&json);
  if (json.is_structured())
    for (Json& child : json) collect(child, all);
}

Json strange(Random& random) {
  switch (below(8, random)) {
    case 0: return static_cast<std::int64_t>(below(12, random)) - 2;
    case 1: return (std::uint64_t{1} << below(34, random)) - below(3, random);
    case 2: return static_cast<double>(random()) / 7 * (below(2, random) == 0 ? 1 : -1e30);
    case 3: return nullptr;
    case 4: return below(2, random) == 0;
    case 5: return Json::array({below(4, random), 1});
    case 6: return Json::object();
    default: {
      constexpr const char* texts[] = {
          "",        "VEC3", "SCALAR",        "MAT4",       "MASK",
          "BLEND",   "a\nb", "data:;base64,", "/materials", "KHR_mesh_quantization",
          "leaf.png"};
      return texts[below(std::size(texts), random)];
    }
  }
}

void mutate(Json& json, Random& random) {
  std::vector<Json*> all;
  collect(json, all);
  Json& value = *all[below(all.size(), random)];
  constexpr int component_types[] = {5120, 5121, 5122, 5123, 5124, 5125, 5126, 5130};
  switch (below(6, random)) {
    case 0: value = Json(*all[below(all.size(), random)]); return;
    case 1:
      if (value.is_structured() && !value.empty()) {
        auto element = value.begin();
        std::advance(element, static_cast<std::ptrdiff_t>(below(value.size(), random)));
        value.erase(element);
      }
      return;
    case 2:
      if (value.is_array() && !value.empty() && value.size() < 100)
        value.push_back(Json(value[below(value.size(), random)]));
      else if (value.is_number_unsigned())
        value = value.get<std::uint64_t>() + below(9, random) - 4;
      return;
    case 3:
      if (value.is_number()) value = component_types[below(std::size(component_types), random)];
      return;
    default: value = strange(random);
  }
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  Random random(seed);
  const auto as_bytes = [&] { return LLVMFuzzerMutate(data, size, max_size); };
  if (size < 3 || *data == 'r' || below(4, random) == 0) return as_bytes();
  const std::uint8_t *const first = data + 1, *const end = data + size;
  const std::uint8_t* const json_end = std::find(first, end, std::uint8_t{0});
  Json json = Json::parse(first, json_end, nullptr, false);
  if (json.is_discarded()) return as_bytes();
  std::vector<std::uint8_t> binary(std::min(json_end + 1, end), end);
  if (!binary.empty() && below(3, random) == 0) {
    binary.resize(binary.size() + 8);
    binary.resize(LLVMFuzzerMutate(binary.data(), binary.size() - 8, binary.size()));
  } else {
    for (std::size_t times = 1 + below(3, random); times > 0; --times) mutate(json, random);
  }
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() + binary.size() + 2 > max_size) return as_bytes();
  std::copy(text.begin(), text.end(), data + 1);
  data[text.size() + 1] = 0;
  std::copy(binary.begin(), binary.end(), data + text.size() + 2);
  return text.size() + binary.size() + 2;
}
