#include "proofs/plugin.hpp"

#include "proofs/bake/plugin_subject.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/index/plugin_subject.hpp"
#include "proofs/micromap/plugin_subject.hpp"
#include "proofs/tree/plugin_subject.hpp"
#include "proofs/vq/plugin_subject.hpp"

namespace mmverify::proofs {

std::vector<PluginSubject> plugin_subjects(const std::string& file, double timeout_seconds) {
  const auto library = std::make_shared<const dock::Library>(file, dock::Options{timeout_seconds, [] {
                                                                                   if (interrupted())
                                                                                     throw Interrupted();
                                                                                 }});
  std::vector<PluginSubject> all;
  for (const auto& s : index::plugin_subjects(library))
    all.push_back({s->arithmetic() == index::Arithmetic::binary64 ? "f64" : "f32", s});
  const auto name = [&](const char* kind) { return all.empty() ? file : file + ":" + kind; };
  if (const auto s = tree::plugin_subject(name("tree"), library)) all.push_back({"tree", s});
  if (const auto s = micromap::plugin_subject(name("micromap"), library)) all.push_back({"micromap", s});
  if (const auto s = vq::plugin_subject(name("vq"), library)) all.push_back({"vq", s});
  if (const auto s = bake::plugin_subject(name("bake"), library)) all.push_back({"bake", s});
  return all;
}

PluginName plugin_name(const std::string& name) {
  for (const std::string kind : {"f32", "f64", "tree", "micromap", "vq", "bake"})
    if (name.ends_with(":" + kind)) return {name.substr(0, name.size() - kind.size() - 1), kind};
  return {name, {}};
}

}  // namespace mmverify::proofs
