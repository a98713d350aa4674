#include "cli/arguments/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>

#include "cli/arguments/nearest_word.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/prove/shader.hpp"
#include "cli/prove/subject_advice.hpp"
#include "proofs/engine/shape.hpp"
#include "proofs/registry/plugin.hpp"
#include "proofs/registry/registry.hpp"
#include "proofs/registry/topics.hpp"

namespace mmverify::cli {

using namespace proofs;

Levels parse_levels(const std::string& text, const char* option) {
  const Groups parts = groups_of(text, R"(([0-9]{1,3})(?:\.\.([0-9]{1,3}))?)");
  if (!parts) throw UsageError(fmt::format("{} {}: write A..B or A, for example 0..8", option, text));
  const auto first = static_cast<Level>(std::stoul((*parts)[1]));
  const auto last = (*parts)[2].empty() ? first : static_cast<Level>(std::stoul((*parts)[2]));
  if (first > last) throw UsageError(fmt::format("{} {}: {} comes after {}", option, text, first, last));
  return {first, last};
}

Levels parse_levels(const std::string& text) {
  const auto [first, last] = parse_levels(text, "--levels");
  if (last > max_level())
    throw UsageError(fmt::format("--levels {}: the highest level is {}", text, max_level()));
  return {first, last};
}

Level parse_level(const std::string& text) {
  if (!groups_of(text, "[0-9]{1,3}"))
    throw UsageError(fmt::format("--level {}: write one level, for example 5", text));
  const auto level = static_cast<Level>(std::stoul(text));
  if (level > max_level())
    throw UsageError(fmt::format("--level {}: the highest level is {}", text, max_level()));
  return level;
}

std::function<std::string(const std::string&)> finite_within(double least, double most) {
  return [least, most](const std::string& text) -> std::string {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end != text.c_str() && *end == 0 && value >= least && value <= most) return {};
    return fmt::format("'{}' is not a number from {} to {}", text, least, most);
  };
}

namespace {

/// The parts between commas: "4," has two, the second one empty.
std::vector<std::string> parts_between_commas(const std::string& text) {
  std::vector<std::string> parts{""};
  for (const char c : text)
    if (c == ',')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

}  // namespace

std::function<std::string(const std::string&)> each_finite_within(double least, double most) {
  return [one = finite_within(least, most), least, most](const std::string& text) -> std::string {
    for (const std::string& part : parts_between_commas(text)) {
      if (part.empty())
        return fmt::format(
            "'{}': nothing stands before or after a comma, where a number from {} to {} is due", text, least,
            most);
      if (std::string wrong = one(part); !wrong.empty()) return wrong;
    }
    return {};
  };
}

std::vector<double> parse_numbers(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& part : parts_between_commas(text))
    numbers.push_back(std::strtod(part.c_str(), nullptr));
  return numbers;
}

proofs::bake::BakeSubjectPtr parse_baker(const std::string& text, double timeout_seconds) {
  for (const SubjectPtr& subject : parse_subject(text, timeout_seconds))
    if (auto baker = std::dynamic_pointer_cast<const bake::BakeSubject>(subject);
        baker != nullptr && baker->functions.bake)
      return baker;
  throw UsageError(fmt::format("--subject {}: not a baker; it exports no entry point `bake`", text));
}

namespace {

/// Reads a whole number below 2^64, in digits only.
std::optional<std::uint64_t> whole(const std::string& text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::function<std::string(const std::string&)> whole_within(std::uint64_t least, std::uint64_t most) {
  return [least, most](const std::string& text) -> std::string {
    const auto value = whole(text);
    if (value && *value >= least && *value <= most) return {};
    return fmt::format("'{}' is not a whole number from {} to {}", text, least, most);
  };
}

std::string fits_64_bits(const std::string& text) {
  return whole(text) ? std::string() : fmt::format("'{}' is no whole number below 2^64", text);
}

std::string fits_a_size(const std::string& text) {
  return text.starts_with("-") || text.size() > 15 ? "bytes, as 500MB or 2GB" : "";
}

std::string shell_quoted(const std::string& text) {
  constexpr char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./:=,+-";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted.append(c == '\'' ? "'\\''" : std::string(1, c));
  return quoted.append("'");
}

std::string meant_law(const std::string& name, bool topics_too) {
  if (std::string meant = meant_as_subject(name); !meant.empty()) return meant;
  std::vector<std::string> known;
  for (const Law& law : laws()) known.push_back(law.id);
  if (topics_too)
    for (const Topic& topic : topics()) known.emplace_back(topic.name);
  return did_you_mean(name, known);
}

std::vector<const Law*> parse_laws(const std::vector<std::string>& names, Tier tier) {
  std::vector<const Law*> chosen;
  for (const std::string& name : names) {
    const auto found = laws_named(name);
    if (found.empty())
      throw UsageError(fmt::format("no law or topic is called '{}'; `mmverify list` names them all{}", name,
                                   meant_law(name, true)));
    bool any = false;
    for (const Law* law : found) {
      if ((law->by_id_only || (law->long_only && tier != Tier::long_run)) && law->id != name) continue;
      any = true;
      if (std::find(chosen.begin(), chosen.end(), law) == chosen.end()) chosen.push_back(law);
    }
    // An empty list of laws would stand for every law.
    if (!any)
      throw UsageError(fmt::format("{}: the fast tier has none of its laws; write --tier long", name));
  }
  return chosen;
}

namespace {

/// Reads lines KEY: VALUE; a line without a colon gets the key "about".
std::vector<std::pair<std::string, std::string>> keys_and_values(const std::string& text) {
  std::vector<std::pair<std::string, std::string>> all;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos)
      all.emplace_back(line.substr(0, colon), line.substr(colon + 2));
    else if (!line.empty())
      all.emplace_back("about", line);
  }
  return all;
}

/// The subject that a name was probably meant to be, as the rest of a sentence; empty if none is near.
std::string meant_subject(const std::string& name) {
  std::error_code none;
  const bool is_file = std::filesystem::is_regular_file(name, none);
  if (const std::string way = way_to_build(name); is_file && !way.empty()) return "; the file is " + way;
  if (is_file) return fmt::format("; did you mean {}?", as_path(name));
  std::vector<std::string> known;
  for (const SubjectPtr& s : subjects()) known.push_back(s->name());
  return did_you_mean(name, known);
}

/// The subjects of a library, or the one that FILE:KIND names.
std::vector<SubjectPtr> of_library(const std::string& name, double timeout_seconds,
                                   std::vector<RunsOn>* runs_on) {
  std::error_code error;
  const auto [file, kind] = std::filesystem::exists(name, error) ? PluginName{name, {}} : plugin_name(name);
  refuse_no_library(file);
  try {
    dock::Options options;
    options.timeout_seconds = timeout_seconds;
    return subjects_of(open_library(file, options), kind, runs_on);
  } catch (const dock::NotHere& why) {
    return absent_subjects(name, {}, why.what());
  } catch (const dock::CannotLoad& why) {
    throw EnvironmentError(why.what() + advice_on_library(file, why.what()));
  }
}

}  // namespace

void refuse_no_library(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw EnvironmentError(fmt::format("{}: no such file", file));
  if (!std::filesystem::is_regular_file(file, error))
    throw EnvironmentError(fmt::format("{}: not a file; name a shared library", file));
  if (const std::string way = way_to_build(file); !way.empty())
    throw EnvironmentError(fmt::format("{}: {}", file, way));
}

std::vector<SubjectPtr> subjects_of(const dock::LibraryPtr& library, const std::string& kind,
                                    std::vector<RunsOn>* runs_on) {
  std::vector<SubjectPtr> chosen;
  for (const PluginSubject& offered : plugin_subjects(library))
    if (kind.empty() || kind == offered.kind) chosen.push_back(offered.subject);
  if (chosen.empty())
    throw UsageError(fmt::format("{}: it exports no entry point of topic {}", library->path(), kind));
  if (runs_on != nullptr && library->description().max_level == 0)
    for (const SubjectPtr& subject : chosen)
      if (subject->topic() == "index" || subject->topic() == "tree" || subject->topic() == "dag" ||
          subject->topic() == "attribute") {
        runs_on->push_back(
            {library->path(),
             {},
             {fmt::format("{}: its max_level is 0, so its entry points of {} are asked about level 0 alone, "
                          "which decides next to nothing; is .max_level forgotten?",
                          library->path(), subject->topic())}});
        break;
      }
  if (const std::string text = library->runs_on(); runs_on != nullptr && !text.empty())
    runs_on->push_back({library->path(), keys_and_values(text), {}});
  return chosen;
}

std::vector<SubjectPtr> parse_subject(const std::string& name, double timeout_seconds,
                                      std::vector<RunsOn>* runs_on) {
  if (SubjectPtr subject = find_subject(name)) return {subject};
  if (is_shader(name)) return of_shader(name, timeout_seconds, runs_on);
  if (name.find('/') != std::string::npos || plugin_name(name).file.ends_with(".so"))
    return of_library(name, timeout_seconds, runs_on);
  throw UsageError(
      fmt::format("no subject is called '{}'; `mmverify list` names the built-in ones, and a library or a "
                  "shader has a path, as ./mine.so{}",
                  name, meant_subject(name)));
}

std::string level_ranges(const std::vector<Level>& levels) {
  std::string text;
  for (std::size_t from = 0; from < levels.size();) {
    std::size_t to = from;
    while (to + 1 < levels.size() && levels[to + 1] == levels[to] + 1) ++to;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", levels[from]);
    if (to != from) text += fmt::format("..{}", levels[to]);
    from = to + 1;
  }
  return text;
}

std::string grouped(std::uint64_t n) {
  std::string digits = fmt::format("{}", n);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

}  // namespace mmverify::cli
