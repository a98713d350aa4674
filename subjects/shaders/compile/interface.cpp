#include "subjects/shaders/compile/interface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "subjects/shaders/compile/tools.hpp"
#include "subjects/shaders/device/manifest.hpp"

namespace mmverify::shaders {
namespace {

using nlohmann::json;

std::string name_of(const json& resource) {
  const std::string name = resource.value("name", "");
  return name.empty() ? "" : fmt::format(" (`{}`)", name);
}

/// spirv-cross's groups of resources that take a binding, other than storage buffers.
struct Group {
  const char *key, *is;
};
constexpr Group foreign[] = {{"ubos", "a uniform buffer"},
                             {"textures", "a sampled image"},
                             {"images", "a storage image"},
                             {"separate_images", "an image"},
                             {"separate_samplers", "a sampler"},
                             {"subpass_inputs", "a subpass input"},
                             {"acceleration_structures", "an acceleration structure"},
                             {"counters", "a counter"}};

class Reader {
 public:
  explicit Reader(const json& all) : all_(all) {}

  Interface read() {
    for (const json& buffer : group("ssbos")) {
      const std::string here = place(buffer);
      const auto set = buffer.value("set", 0u), binding = buffer.value("binding", 0u);
      if (set != 0 || binding >= bindings)
        fault(fmt::format("{} is bound by nobody: there are bindings 0 to {} of set 0", here, bindings - 1));
      else if (buffer.contains("array"))
        fault(fmt::format("{} is an array of storage buffers, and one is bound there", here));
    }
    read_answers();
    for (const Group& its : foreign)
      for (const json& resource : group(its.key))
        fault(fmt::format("{} is {}, and what is bound are storage buffers, at bindings 0 to {} of set 0",
                          place(resource), its.is, bindings - 1));
    for (const json& block : group("push_constants")) {
      const std::uint64_t end = end_of_struct(block.value("type", ""), 0);
      if (end > sizeof(PushConstants))
        fault(fmt::format(
            "its push constants{} take {} bytes, and {} are given: uint count, level, first, second, bytes",
            name_of_type(block), end, sizeof(PushConstants)));
    }
    for (const json& entry : group("entryPoints"))
      for (const json& by_constant : entry.value("workgroup_size_is_spec_constant_id", json::array()))
        if (by_constant == true) {
          fault("its workgroup's size is a specialization constant; write the number itself");
          break;
        }
    for (const json& constant : group("specialization_constants"))
      found_.constants.push_back(fmt::format("{}{}: {}", constant.value("id", 0u), name_of(constant),
                                             constant.value("default_value", json()).dump()));
    return std::move(found_);
  }

 private:
  json group(const char* key) const { return all_.value(key, json::array()); }
  void fault(std::string text) { found_.faults.push_back(std::move(text)); }
  static std::string place(const json& resource) {
    return fmt::format("binding {} of set {}{}", resource.value("binding", 0u), resource.value("set", 0u),
                       name_of(resource));
  }

  /// An entry point that does not use the answers' binding writes them elsewhere, if it can write at all.
  void read_answers() {
    std::string writable;
    for (const json& buffer : group("ssbos")) {
      if (buffer.value("set", 0u) == 0 && buffer.value("binding", 0u) == answer_binding) return;
      if (writable.empty() && !buffer.value("readonly", false)) writable = place(buffer);
    }
    if (!writable.empty())
      fault(fmt::format("it does not use binding {} of set 0, where answers go; it may write to {}",
                        answer_binding, writable));
  }

  /// The name of a block's type: spirv-cross numbers the variable of a block without a name.
  std::string name_of_type(const json& block) const {
    const std::string type = block.value("type", "");
    return all_.contains("types") && all_["types"].contains(type) ? name_of(all_["types"][type]) : "";
  }

  std::uint64_t end_of_struct(const std::string& type, unsigned depth) const {
    constexpr unsigned deepest = 16;
    const json none = json::array();
    std::uint64_t end = 0;
    if (depth < deepest && all_.contains("types") && all_["types"].contains(type))
      for (const json& member : all_["types"][type].value("members", none))
        end = std::max(end, member.value("offset", std::uint64_t{0}) + bytes_of(member, depth));
    return end;
  }
  std::uint64_t bytes_of(const json& member, unsigned depth) const {
    const std::string type = member.value("type", "");
    std::uint64_t one = type.starts_with("_") ? end_of_struct(type, depth + 1) : bytes_of_numbers(type);
    if (member.contains("matrix_stride"))  // columns or rows: at most four, so the size is never too small
      one = 4 * member.value("matrix_stride", std::uint64_t{16});
    std::uint64_t count = 1;
    for (const json& length : member.value("array", json::array())) count *= length.get<std::uint64_t>();
    return count <= 1 ? one : (count - 1) * member.value("array_stride", one) + one;
  }
  /// The size of a scalar or vector type: uint, float, uvec2, u64vec3, double, ...
  static std::uint64_t bytes_of_numbers(const std::string& type) {
    const auto has = [&type](const char* text) { return type.find(text) != std::string::npos; };
    const std::uint64_t lanes =
        has("vec") && !type.empty() ? static_cast<std::uint64_t>(type.back() - '0') : 1;
    const bool twice = has("64") || has("double") || type.starts_with("dvec");
    return lanes * (twice ? 8 : has("16") || has("half") ? 2 : has("8") ? 1 : 4);
  }

  const json& all_;
  Interface found_;
};

}  // namespace

Interface interface_of(const std::string& reflected) {
  try {
    return Reader(json::parse(reflected)).read();
  } catch (const json::exception& why) {
    throw std::runtime_error(std::string("spirv-cross describes it in no JSON: ") + why.what());
  }
}

std::optional<Interface> read_interface(const std::string& spirv, const program::Folder& folder) {
  // A module may declare more than its entry point uses; only what is used has to be bound.
  const std::string used = folder.file("used.spv");
  const auto cut =
      ended({"spirv-opt", "--eliminate-dead-functions", "--eliminate-dead-variables", spirv, "-o", used});
  const auto end = ended({"spirv-cross", cut && cut->succeeded ? used : spirv, "--reflect"});
  if (!end) return std::nullopt;
  if (!end->succeeded)
    throw std::runtime_error(fmt::format("spirv-cross, {}: {}", end->how, end->errors + end->out));
  return interface_of(end->out);
}

}  // namespace mmverify::shaders
