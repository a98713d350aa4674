#include "cli/report_input.hpp"

#include <fmt/format.h>

#include "cli/exit_code.hpp"
#include "cli/read_json.hpp"
#include "gate/contradictions.hpp"
#include "gate/figures.hpp"

namespace mmverify::cli {
namespace {

using Json = nlohmann::ordered_json;

// The shapes: an object's keys, "key?" for one that may be missing, "key|null" for one that may be null, "*"
// for any; [x] for a list of x; and of a value the name of its kind.

constexpr char result_shape[] = R"({
  "schema": "text",
  "tool": {"version": "text", "compiler": "text", "flags": "text", "cpu?": "text", "threads?": "number",
           "seed": "number", "spec_hash": "text", "source_hash?": "text"},
  "results": [{"law": "text", "topic": "text", "subject": "text", "level|null": "level", "method": "text",
               "domain": "text", "verdict": "verdict", "reason?": "text", "cases_expected": "number",
               "cases_run": "number", "mismatches": "number",
               "counterexample|null": {"case": "text", "level?|null": "level", "hex?": "text",
                                       "expected?": "scalar", "got?": "scalar", "replay?": "text"},
               "more_counterexamples?": [{"case": "text", "level?|null": "level", "hex?": "text",
                                          "expected?": "scalar", "got?": "scalar", "replay?": "text"}],
               "seconds": "number"}],
  "mutants?": [{"law": "text", "mutant": "text", "killed": "flag"}],
  "diagnoses?": [{"law": "text", "subject": "text", "lines": ["text"]}],
  "shard?": {"number": "number", "of": "number", "finished": "flag"},
  "scene?": {
    "file": "text",
    "plan": {"triangles": "number", "triangles_placed": "number", "baked_triangles": "number",
             "baked_triangles_placed": "number", "distinct_triangles": "number", "reordered_triangles": "number",
             "surfaces": [{"image": "text", "width": "number", "height": "number", "mode": "text",
                           "filter?": "text", "cutoff": "number", "factor": "number"}],
             "left_out": [{"mesh": "number", "primitive": "number", "triangles": "number", "why": "text"}],
             "left_out_laws?": [{"what": "text", "why": "text"}]},
    "bake?": {"micro_triangles": "number", "leaves": "number", "exact": "number",
              "triangles_by_level": {"*": "number"}, "lowered": "number",
              "states": {"T": "number", "O": "number", "UT": "number", "UO": "number"},
              "load_seconds": "number", "bake_seconds": "number"},
    "saved?": "SAVED", "footprint?": "FOOTPRINT", "vq2?": "SQUARES", "vq4?": "SQUARES",
    "pairs?": {"pairs": "number", "distinct": "number", "unpaired": "number"},
    "sizes?": [{"level": "level", "footprint": "FOOTPRINT", "saved": "SAVED"}]}})";

constexpr char saved_shape[] =
    R"({"area": "number", "transparent": "number", "opaque": "number", "unknown": "number"})";
constexpr char squares_shape[] =
    R"({"maps": "number", "uniform": "number", "bytes": "number", "regions": "number",
  "unknown": "number", "substitutions": "number"})";
constexpr char footprint_shape[] = R"({"micromaps": "number", "special_indices": "number",
  "record_bytes": "number", "index_bytes": "number", "array_data_bytes": "number", "texture_bytes": "number",
  "vertex_data_bytes": "number", "modes": [{"states": "number", "micromaps": "number", "data_bytes": "number",
  "tree_bytes": "number", "random_access_tree_bytes": "number", "bitmask_bytes": "number"}]})";

constexpr char bench_shape[] =
    R"({"version": "text", "compiler": "text", "flags": "text", "cpu?": "text", "seed": "number",
  "spec_hash": "text", "samples?": "number", "rounds?": "number", "maps?": "text"})";

/// By topic; "tool" is bench_shape.
constexpr std::pair<const char*, const char*> bench_shapes[] = {
    {"index", R"({"schema": "text", "topic": "text", "tool": "TOOL",
      "rows": [{"subject": "text", "level": "level", "ns_per_index": "number"}],
      "subjects": [{"subject": "text", "numbers": "text", "order": "text",
        "errors": [{"level": "level", "inputs": "text", "samples": "number", "mismatches": "number"}]}]})"},
    {"tree", R"({"schema": "text", "topic": "text", "tool": "TOOL",
      "rows": [{"states": "number", "level": "level",
        "forms": [{"form": "text", "bits_per_micro_triangle": "number", "ns_per_lookup": "number"}]}]})"},
    {"vq", R"({"schema": "text", "topic": "text", "tool": "TOOL",
      "rows": [{"map": "text", "states_16": "number", "states_32": "number",
        "savings": {"64x2": "number", "8x8": "number", "16x16": "number", "32x32": "number"},
        "vq2": [{"encoder": "text", "substitutions": "number", "savings": "number", "ms": "number"}],
        "vq4": [{"encoder": "text", "substitutions": "number", "savings": "number", "ms": "number"}]}]})"},
    {"bake", R"({"schema": "text", "topic": "text", "tool": "TOOL",
      "rows": [{"level": "level", "bakers": [{"baker": "text", "states": "number", "wrong": "number",
        "needless": "number", "ns": "number"}]}]})"},
    {"sweep", R"({"schema": "text", "topic": "text", "threads": "number",
      "levels": [{"level": "level", "cells": "number", "plain_per_second?": "number",
        "step": {"seconds": "number"}, "impl": {"seconds": "number"}}]})"},
    {"subject", R"({"schema": "text", "topic": "text", "subject": "text", "level": "level",
      "bare_ns": "number", "isolated_ns": "number", "judged_ns": "number"})"},
    {"scene", R"({"schema": "text", "topic": "text", "file": "text",
      "rows": [{"level": "level", "fastest_ns": "number", "centre_ns": "number"}]})"},
};

constexpr const char* verdicts[] = {"proved", "refuted", "checked", "broken", "not_applicable", "incomplete"};

struct Kind {
  const char *name, *words;
  bool (*is)(const Json&);
};

constexpr Kind kinds[] = {
    {"text", "a text", [](const Json& j) { return j.is_string(); }},
    {"number", "a number, 0 or more", [](const Json& j) { return j.is_number() && j.get<double>() >= 0; }},
    {"flag", "true or false", [](const Json& j) { return j.is_boolean(); }},
    {"scalar", "a text or a number", [](const Json& j) { return j.is_string() || j.is_number(); }},
    {"level", "a level, 0 to 31",
     [](const Json& j) { return j.is_number_unsigned() && j.get<std::uint64_t>() <= 31; }},
    {"verdict", "a verdict",
     [](const Json& j) {
       return std::any_of(std::begin(verdicts), std::end(verdicts), [&](const char* v) { return j == v; });
     }},
};

[[noreturn]] void refuse(const std::string& place, const std::string& what) {
  throw EnvironmentError(fmt::format("{}: {}", place, what));
}

/// The value as a message may quote it.
std::string quoted(const Json& value) {
  if (value.is_structured()) return value.is_array() ? "a list" : "an object";
  std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= 40 ? text : text.substr(0, 37) + "...";
}

/// The value as far as the shape names it; EnvironmentError where it is not of that shape.
Json taken(const Json& value, const Json& shape, const std::string& place) {
  if (shape.is_string()) {
    const std::string name = shape.get<std::string>();
    for (const Kind& kind : kinds)
      if (kind.name == name) {
        if (!kind.is(value))
          refuse(place, fmt::format("{} should stand here, not {}", kind.words, quoted(value)));
        return value;
      }
    throw std::logic_error("no kind is called " + name);
  }
  if (shape.is_array()) {
    if (!value.is_array()) refuse(place, fmt::format("a list should stand here, not {}", quoted(value)));
    Json list = Json::array();
    for (const Json& one : value)
      list.push_back(taken(one, shape[0], fmt::format("{}[{}]", place, list.size())));
    return list;
  }
  if (!value.is_object()) refuse(place, fmt::format("an object should stand here, not {}", quoted(value)));
  Json object = Json::object();
  for (const auto& [written, inner] : shape.items()) {
    std::string key = written;
    const auto has = [&key](const char* mark) {
      const bool marked = key.ends_with(mark);
      if (marked) key.resize(key.size() - std::string_view(mark).size());
      return marked;
    };
    if (key == "*") {
      for (const auto& [name, one] : value.items()) object[name] = taken(one, inner, place + "." + name);
      continue;
    }
    const bool nullable = has("|null"), optional = has("?");
    if (!value.contains(key)) {
      if (!optional) refuse(place, fmt::format("no \"{}\"", key));
      continue;
    }
    const Json& one = value.at(key);
    object[key] = nullable && one.is_null() ? one : taken(one, inner, place + "." + key);
  }
  return object;
}

/// The shape with its named parts put in.
Json shape_of(const char* text, const std::vector<std::pair<std::string, Json>>& parts) {
  Json shape = Json::parse(text);
  const auto put = [&](const auto& self, Json& part) -> void {
    if (part.is_string())
      for (const auto& [name, value] : parts)
        if (part == name) {
          part = value;
          return;
        }
    if (part.is_structured())
      for (Json& inner : part) self(self, inner);
  };
  put(put, shape);
  return shape;
}

Json result_run(const Json& j, const std::string& path) {
  static const Json shape = shape_of(result_shape, {{"SAVED", Json::parse(saved_shape)},
                                                    {"SQUARES", Json::parse(squares_shape)},
                                                    {"FOOTPRINT", Json::parse(footprint_shape)}});
  Json run = taken(j, shape, path);
  if (run["results"].empty()) refuse(path, "results: there are none");
  try {
    gate::refuse_contradictions(j);
  } catch (const gate::NoResult& why) {
    refuse(path, why.what());
  }
  const auto two_modes = [&](const Json& footprint, const std::string& place) {
    if (footprint["modes"].size() != 2)
      refuse(place + ".modes", "two should stand here, of 2 and of 4 states");
  };
  if (!run.contains("scene")) return run;
  const Json& scene = run["scene"];
  if (scene.contains("footprint")) two_modes(scene["footprint"], path + ".scene.footprint");
  if (scene.contains("sizes"))
    for (const Json& at : scene["sizes"]) two_modes(at["footprint"], path + ".scene.sizes");
  return run;
}

Json bench_run(const Json& j, const std::string& place) {
  const std::string topic =
      j.contains("topic") && j["topic"].is_string() ? j["topic"].get<std::string>() : "";
  for (const auto& [name, text] : bench_shapes)
    if (topic == name) {
      Json run = taken(j, shape_of(text, {{"TOOL", Json::parse(bench_shape)}}), place);
      for (const char* list : {"rows", "levels"})
        if (run.contains(list) && run[list].empty()) refuse(place, fmt::format("{}: there are none", list));
      return run;
    }
  refuse(place, fmt::format("no bench is of a topic '{}'", topic));
}

std::string schema_of(const Json& j) {
  return j.is_object() && j.contains("schema") && j["schema"].is_string() ? j["schema"].get<std::string>()
                                                                          : "";
}

}  // namespace

std::vector<ReportInput> read_report_input(const std::string& path) {
  const std::string text = read_text(path);
  Json j;
  try {
    j = Json::parse(text);
  } catch (const Json::exception& error) {
    refuse(path, error.what());
  }
  const bool several = j.is_array() && !j.empty();
  std::vector<ReportInput> inputs;
  for (std::size_t k = 0; k < (several ? j.size() : 1); ++k) {
    const Json& one = several ? j[k] : j;
    const std::string place = several ? fmt::format("{}[{}]", path, k) : path, schema = schema_of(one);
    if (schema == "mmverify.result/1")
      inputs.push_back({path, result_run(one, place)});
    else if (schema == "mmverify.bench/1")
      inputs.push_back({path, bench_run(one, place)});
    else
      refuse(place,
             fmt::format("{}; mmverify report takes what prove, scene and bench write with --json",
                         schema.empty() ? "no schema of mmverify"
                                        : fmt::format("schema '{:.60}' is none that it knows", schema)));
  }
  return inputs;
}

}  // namespace mmverify::cli
