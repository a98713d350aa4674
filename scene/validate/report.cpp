#include "scene/validate/report.hpp"

#include <utility>

#include "scene/read/bad_scene.hpp"
#include "scene/validate/suspect_record.hpp"
#include "scene/validate/vuids.hpp"

namespace mmverify::scene {

void Report::add(std::string_view rule, const std::string& pointer, const std::string& found,
                 std::vector<std::string_view> vuids) {
  if (++counts_[{rule, pointer}] <= most) list_.push_back({rule, pointer, found, std::move(vuids)});
}

void Report::count(std::string_view rule, const std::string& pointer, std::uint64_t more) {
  counts_[{rule, pointer}] += more;
}

void Report::add(const impl::micromap::Violation& violation, const impl::micromap::Input& in,
                 const std::string& pointer) {
  // "id (sets): words"
  const std::string line = impl::micromap::describe(violation);
  const char* const rule = impl::micromap::text(violation.rule).id;
  std::string found = line.substr(line.find(": ") + 2);
  using enum impl::micromap::Rule;
  const bool of_bytes = violation.rule == record_overlap || violation.rule == record_region ||
                        violation.rule == record_level_12 || violation.rule == record_format ||
                        violation.rule == counts_array;
  if (of_bytes && suspected_.insert(in.records.data()).second)
    if (const std::string suspect = suspect_record(in); !suspect.empty()) found += "; " + suspect;
  add(rule, pointer, found, vuids_of(rule, in.sets, cases_of(violation, in)));
}

std::vector<FileViolation> Report::taken() {
  std::map<std::pair<std::string_view, std::string>, std::size_t> listed;
  std::vector<FileViolation> all;
  for (FileViolation& violation : list_) {
    const std::pair<std::string_view, std::string> key{violation.rule, violation.pointer};
    const std::uint64_t number = ++listed[key], count = counts_[key];
    all.push_back(std::move(violation));
    if (number == most && count > most)
      all.push_back(
          {key.first, key.second, "and " + std::to_string(count - most) + " more", all.back().vuids});
  }
  return all;
}

std::string found(const nlohmann::json& value) {
  return value.is_structured() ? std::string("an ") + value.type_name() : shown(value.dump());
}

std::optional<std::uint64_t> whole(const nlohmann::json& value, std::uint64_t end) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= end) return {};
  return value.get<std::uint64_t>();
}

std::optional<std::span<const unsigned char>> plain_view(const Document& document, const Buffers& buffers,
                                                         std::size_t view, const std::string& pointer,
                                                         Report& report) {
  if (const nlohmann::json& json = document.json["bufferViews"][view];
      report.newest() && json.contains("byteStride"))
    report.add("view.stride", pointer,
               place("bufferView", view) + " has a byteStride of " + found(json["byteStride"]));
  const auto add = [&](const char* rule, const BadScene& bad) {
    const std::string what = bad.what(), file = document.file + ": ";
    report.add(rule, pointer, what.starts_with(file) ? what.substr(file.size()) : what);
  };
  try {
    return buffers.view(view);
  } catch (const UnreadExtension& unread) {
    add("limits.extension", unread);
  } catch (const DamagedData& damaged) {
    add("view.compressed", damaged);
  } catch (const BadScene& outside) {
    add("view.inside", outside);
  }
  return {};
}

std::string describe(const FileViolation& violation) {
  return std::string(violation.rule) + ": " + (violation.pointer.empty() ? "/" : violation.pointer) + ": " +
         violation.found;
}

}  // namespace mmverify::scene
