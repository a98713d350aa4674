#include "proofs/plugin.hpp"

#include <algorithm>

#include "proofs/engine/interrupt.hpp"

namespace mmverify::proofs {
std::vector<PluginSubject> plugin_subjects(const std::string& file, double timeout_seconds) {
  const auto library = std::make_shared<const dock::Library>(file, dock::Options{timeout_seconds, [] {
                                                                                   if (interrupted())
                                                                                     throw Interrupted();
                                                                                 }});
  std::vector<PluginSubject> all;
  std::vector<Topic> in_order(topics().begin(), topics().end());
  std::sort(in_order.begin(), in_order.end(),
            [](const Topic& a, const Topic& b) { return a.first_entry < b.first_entry; });
  for (const Topic& topic : in_order)
    for (PluginSubject& subject : topic.of_library(library, all.empty())) all.push_back(std::move(subject));
  return all;
}

PluginName plugin_name(const std::string& name) {
  for (const Topic& topic : topics())
    for (const std::string& kind : topic.kinds)
      if (name.ends_with(":" + kind)) return {name.substr(0, name.size() - kind.size() - 1), kind};
  return {name, {}};
}

}  // namespace mmverify::proofs
