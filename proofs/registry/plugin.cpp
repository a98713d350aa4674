#include "proofs/registry/plugin.hpp"

#include "proofs/engine/interrupt.hpp"

namespace mmverify::proofs {

namespace {

/// Libraries that are open, for change_of().
std::vector<std::weak_ptr<const dock::Library>>& opened() {
  static std::vector<std::weak_ptr<const dock::Library>> all;
  return all;
}

class Absent : public Subject {
 public:
  Absent(const std::string& topic, const std::string& name, std::string why)
      : Subject(topic, name, "not here"), why_(std::move(why)) {}
  std::string absent() const override { return why_; }
  bool exact() const override { return true; }  // nothing is said of floats either

 private:
  std::string why_;
};

}  // namespace

dock::LibraryPtr open_library(const std::string& file, dock::Options options) {
  options.stop_if_asked = [] {
    if (interrupted()) throw Interrupted();
  };
  auto library = std::make_shared<const dock::Library>(file, options);
  opened().push_back(library);
  return library;
}

std::string change_of(const Subject& subject) {
  for (const auto& one : opened())
    if (const dock::LibraryPtr library = one.lock();
        library && (subject.name() == library->path() || subject.name().starts_with(library->path() + ":")))
      if (std::string change = library->change(); !change.empty()) return change;
  return {};
}

std::vector<PluginSubject> plugin_subjects(const dock::LibraryPtr& library) {
  std::vector<PluginSubject> all;
  std::vector<Topic> in_order(topics().begin(), topics().end());
  std::sort(in_order.begin(), in_order.end(),
            [](const Topic& a, const Topic& b) { return a.first_entry < b.first_entry; });
  for (const Topic& topic : in_order)
    for (PluginSubject& subject : topic.of_library(library, all.empty())) all.push_back(std::move(subject));
  return all;
}

std::vector<SubjectPtr> absent_subjects(const std::string& name, const std::vector<std::string>& entry_points,
                                        const std::string& why) {
  std::vector<SubjectPtr> all;
  for (const Topic& topic : topics())
    for (const dock::EntryPoint& e : dock::entry_points)
      if (e.topic == dock::entry_point(topic.first_entry).topic &&
          std::find(entry_points.begin(), entry_points.end(), e.name) != entry_points.end()) {
        all.push_back(std::make_shared<Absent>(topic.name, name, why));
        break;
      }
  if (all.empty()) all.push_back(std::make_shared<Absent>("index", name, why));
  return all;
}

PluginName plugin_name(const std::string& name) {
  for (const Topic& topic : topics())
    for (const std::string& kind : topic.kinds)
      if (name.ends_with(":" + kind)) return {name.substr(0, name.size() - kind.size() - 1), kind};
  return {name, {}};
}

}  // namespace mmverify::proofs
