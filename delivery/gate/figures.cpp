#include "delivery/gate/figures.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "delivery/gate/contradictions.hpp"
#include "delivery/gate/schema.hpp"

namespace mmverify::gate {
namespace {

using Json = nlohmann::ordered_json;

/// The JSON text of a value. Names may be any bytes.
std::string text_of(const Json& j) { return j.dump(-1, ' ', false, Json::error_handler_t::replace); }

/// Short names of subjects. A library is known by its file's name, since its folder depends on the machine.
/// If several files have one name, as many folders are added as tell them apart.
using Names = std::map<std::string, std::string>;
Names short_names(const std::set<std::string>& subjects) {
  const auto last_parts = [](const std::string& path, std::size_t parts) {
    std::size_t at = path.size();
    while (parts-- != 0 && at != 0 && at != std::string::npos) at = path.rfind('/', at - 1);
    return at == 0 || at == std::string::npos ? path : path.substr(at + 1);
  };
  Names names;
  std::set<std::string> left = subjects;
  for (std::size_t parts = 1; !left.empty(); ++parts) {
    std::map<std::string, std::size_t> uses;
    for (const std::string& path : left) ++uses[last_parts(path, parts)];
    std::erase_if(left, [&](const std::string& path) {
      const std::string name = last_parts(path, parts);
      const bool is_its_own = uses.at(name) == 1 || name == path;
      if (is_its_own) names[path] = name;
      return is_its_own;
    });
  }
  return names;
}
std::set<std::string> subjects_of(const Json& run) {
  std::set<std::string> subjects;
  if (run.contains("results") && run.at("results").is_array())
    for (const Json& result : run.at("results"))
      if (result.is_object() && result.contains("subject") && result.at("subject").is_string())
        subjects.insert(result.at("subject").get<std::string>());
  return subjects;
}

/// "impl", "level 3", "all levels".
std::string name_of(const std::string& field, const Json& value, const Names& subjects) {
  if (value.is_string()) {
    const auto text = value.get<std::string>();
    const auto known = subjects.find(text);
    return field == "subject" && known != subjects.end() ? known->second : text;
  }
  if (value.is_null()) return fmt::format("all {}s", field);
  return fmt::format("{} {}", field, text_of(value));
}

class Walk {
 public:
  Walk(Figures& figures, std::string schema, Names subjects)
      : figures_(figures), schema_(std::move(schema)), subjects_(std::move(subjects)) {}

  /// place: the field's place in the schema, for the rules; name: the figure's name within the group.
  void value(const Json& j, const std::string& place, const std::string& group, const std::string& name) {
    // A rule may leave out a whole object or list; otherwise its members are compared.
    const std::optional<Rule> rule = rule_of(schema_, place);
    if (rule == Rule::left_out) return;
    if (j.is_object()) return object(j, place, group, name);
    if (j.is_array()) return list(j, place, group, name);
    if (!rule) throw NoResult(fmt::format("{}: no rule says how it is compared", place));
    if (rule == Rule::key) return;
    check_kind(j, *rule, place);
    const Value value{text_of(j), j.is_number() ? j.get<double>() : 0};
    if (rule == Rule::setting) {
      figures_.settings[fmt::format("{}{}", group.empty() ? "" : group + " ", name)] = value.text;
      return;
    }
    // Outside a list, the first two names of the path make the group: "scene.bake".
    const std::size_t dot = group.empty() ? name.find('.', name.find('.') + 1) : std::string::npos;
    if (dot == std::string::npos)
      figures_.groups[group][name] = {value, *rule};
    else
      figures_.groups[name.substr(0, dot)][name.substr(dot + 1)] = {value, *rule};
  }

  void object(const Json& j, const std::string& place, const std::string& group, const std::string& name) {
    const auto below = [](const std::string& path, const std::string& field) {
      return path.empty() ? field : path + "." + field;
    };
    for (const auto& [field, of] : j.items()) value(of, below(place, field), group, below(name, field));
  }

 private:
  static void check_kind(const Json& j, Rule rule, const std::string& place) {
    const auto expect = [&](bool holds, const char* what) {
      if (!holds) throw NoResult(fmt::format("{}: {} where {} should be", place, text_of(j), what));
    };
    switch (rule) {
      case Rule::verdict: expect(j.is_string() && is_verdict(j.get<std::string>()), "a verdict"); break;
      case Rule::yes: expect(j.is_boolean(), "true or false"); break;
      case Rule::more:
      case Rule::less: expect(j.is_number() && !(j.get<double>() < 0), "a number of things"); break;
      case Rule::about:
      case Rule::about_more:
      case Rule::about_less: expect(j.is_number() || j.is_null(), "a number"); break;
      // JSON has no infinity: a ratio to a time of 0 is null.
      case Rule::speed_more:
      case Rule::speed_less: expect((j.is_number() && j.get<double>() >= 0) || j.is_null(), "a ratio"); break;
      default: break;
    }
  }

  /// The keys of a list's element, which name its group; empty if it has none.
  std::string keys(const Json& element, const std::string& place) const {
    std::string all;
    if (!element.is_object()) return all;
    for (const auto& [field, of] : element.items())
      if (rule_of(schema_, place + "." + field) == Rule::key)
        all += (all.empty() ? "" : " ") + name_of(field, of, subjects_);
    return all;
  }

  void list(const Json& j, const std::string& place, const std::string& group, const std::string& name) {
    std::size_t k = 0;
    for (const Json& element : j) {
      const std::string about = keys(element, place + "[]");
      if (about.empty()) {
        value(element, place + "[]", group, fmt::format("{}[{}]", name, k++));
        continue;
      }
      // The chief list of a result needs no name in the group's.
      const bool chief = name == "results" || name == "rows";
      std::string full =
          fmt::format("{}{}{}{}", group, group.empty() ? "" : " ", chief ? "" : name + " ", about);
      if (const std::size_t n = ++uses_[full]; n != 1) full = fmt::format("{} ({})", full, n);
      while (figures_.groups.contains(full)) full += '\'';  // an element may call itself "impl (2)"
      figures_.groups[full];
      value(element, place + "[]", full, "");
      leave_out_digests(figures_.groups[full]);
    }
  }

  /// Leaves out the digest unless the verdict is proved: a sample's digest depends on the sample, and a
  /// refuted subject's answers are about to change.
  static void leave_out_digests(std::map<std::string, Figure>& figures) {
    const auto verdict = figures.find("verdict");
    if (verdict != figures.end() && verdict->second.value.text == "\"proved\"") return;
    std::erase_if(figures, [](const auto& figure) { return figure.second.rule == Rule::digest; });
  }

  Figures& figures_;
  std::string schema_;
  Names subjects_;
  std::map<std::string, std::size_t> uses_;  ///< how often each group's name was used
};

std::string schema_in(const Json& j) {
  if (!j.is_object() || !j.contains("schema") || !j.at("schema").is_string())
    throw NoResult("not a result of mmverify: it has no member \"schema\"");
  return j.at("schema").get<std::string>();
}

void add(const Json& run, Figures& figures, std::set<std::string>& topics) {
  const std::string schema = schema_in(run);
  if (schema != "mmverify.result/1" && schema != "mmverify.bench/1")
    throw NoResult(
        fmt::format("schema {}: neither mmverify.result/1 nor mmverify.bench/1", text_of(run.at("schema"))));
  if (!schema_named(schema)) throw NoResult("figures of a bench: mmverify for WebAssembly compares none");
  if (!figures.schema.empty() && figures.schema != schema)
    throw NoResult("runs of several schemas in one file");
  if (!figures.schema.empty() && schema == "mmverify.result/1")
    throw NoResult("several runs in one file; write each run to a file of its own");
  figures.schema = schema;
  if (run.contains("shard"))
    throw NoResult("one shard of a run; put the shards together with mmverify merge first");
  std::string topic;
  if (schema == "mmverify.bench/1") {
    if (!run.contains("topic") || !run.at("topic").is_string()) throw NoResult("topic: there is none");
    topic = run.at("topic").get<std::string>();
    if (!topics.insert(topic).second)
      throw NoResult(fmt::format("topic {}: twice in one file", text_of(topic)));
  }
  if (run.contains("tool") && run.at("tool").is_object() && run.at("tool").contains("cpu") &&
      run.at("tool").at("cpu").is_string())
    figures.processor = run.at("tool").at("cpu").get<std::string>();
  Walk(figures, topic.empty() ? schema : schema + " " + topic, short_names(subjects_of(run)))
      .object(run, "", topic, "");
  refuse_contradictions(run);
}

}  // namespace

std::string unquoted(const std::string& json) {
  return json.size() >= 2 && json.front() == '"' ? json.substr(1, json.size() - 2) : json;
}

Figures figures_of(const Json& result) {
  Figures figures;
  std::set<std::string> topics;
  if (result.is_array())
    for (const Json& run : result) add(run, figures, topics);
  else
    add(result, figures, topics);
  // Elements with keys only have made groups without figures.
  std::erase_if(figures.groups, [](const auto& group) { return group.second.empty(); });
  if (figures.groups.empty()) throw NoResult("nothing in it can be compared");
  return figures;
}

}  // namespace mmverify::gate
