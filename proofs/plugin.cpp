#include "proofs/plugin.hpp"

#include "proofs/bake/plugin_subject.hpp"
#include "proofs/engine/interrupt.hpp"
#include "proofs/index/plugin_subject.hpp"
#include "proofs/micromap/plugin_subject.hpp"
#include "proofs/tree/plugin_subject.hpp"
#include "proofs/vq/plugin_subject.hpp"

namespace mmverify::proofs {
namespace {

template <auto plugin_subject>
SubjectPtr opened(const std::string& name, const dock::LibraryPtr& library) {
  return plugin_subject(name, library);
}

/// Kinds of subjects that a library has one of at most.
struct CodecKind {
  const char* name;
  SubjectPtr (*open)(const std::string& name, const dock::LibraryPtr& library);  ///< null where it has none
};
constexpr CodecKind codec_kinds[] = {{"tree", opened<tree::plugin_subject>},
                                     {"micromap", opened<micromap::plugin_subject>},
                                     {"vq", opened<vq::plugin_subject>},
                                     {"bake", opened<bake::plugin_subject>}};
/// And those of index, by its arithmetic.
constexpr const char *binary32 = "f32", *binary64 = "f64";

}  // namespace

std::vector<PluginSubject> plugin_subjects(const std::string& file, double timeout_seconds) {
  const auto library = std::make_shared<const dock::Library>(file, dock::Options{timeout_seconds, [] {
                                                                                   if (interrupted())
                                                                                     throw Interrupted();
                                                                                 }});
  std::vector<PluginSubject> all;
  for (const auto& s : index::plugin_subjects(library))
    all.push_back({s->arithmetic() == index::Arithmetic::binary64 ? binary64 : binary32, s});
  for (const CodecKind& kind : codec_kinds)
    if (const SubjectPtr s = kind.open(all.empty() ? file : file + ":" + kind.name, library))
      all.push_back({kind.name, s});
  return all;
}

PluginName plugin_name(const std::string& name) {
  std::vector<std::string> known{binary32, binary64};
  for (const CodecKind& kind : codec_kinds) known.push_back(kind.name);
  for (const std::string& kind : known)
    if (name.ends_with(":" + kind)) return {name.substr(0, name.size() - kind.size() - 1), kind};
  return {name, {}};
}

}  // namespace mmverify::proofs
