#include "proofs/registry/topics.hpp"

#include "proofs/array/laws.hpp"
#include "proofs/attribute/laws.hpp"
#include "proofs/bake/dialogue.hpp"
#include "proofs/bake/laws.hpp"
#include "proofs/dag/laws.hpp"
#include "proofs/index/laws.hpp"
#include "proofs/micromap/laws.hpp"
#include "proofs/subdivision/laws.hpp"
#include "proofs/traverse/laws.hpp"
#include "proofs/tree/dialogue.hpp"
#include "proofs/tree/laws.hpp"
#include "proofs/vq/laws.hpp"

namespace mmverify::proofs {
namespace {

/// The subjects of a topic as the engine's type.
template <auto of_topic>
std::vector<SubjectPtr> all() {
  const auto subjects = of_topic();
  return {subjects.begin(), subjects.end()};
}

/// The subjects of a topic that makes one of a library, named FILE:TOPIC or, as the library's first, FILE.
template <auto plugin_subject>
std::vector<PluginSubject> one(const dock::LibraryPtr& library, bool first) {
  using Made = std::invoke_result_t<decltype(plugin_subject), std::string, dock::LibraryPtr>;
  const std::string topic = Made::element_type::Functions::topic;
  const SubjectPtr subject = plugin_subject(first ? library->path() : library->path() + ":" + topic, library);
  if (subject == nullptr) return {};
  return {{topic, subject}};
}

std::vector<PluginSubject> by_arithmetic(const dock::LibraryPtr& library, bool) {
  std::vector<PluginSubject> found;
  for (const auto& s : index::plugin_subjects(library))
    found.push_back({s->functions.arithmetic == index::Arithmetic::binary64 ? "f64" : "f32", s});
  return found;
}

using dock::Call;

// The table has a row for each topic.
// clang-format off
const std::vector<Topic> table{
    {"index", {"index", "paper"}, index::laws, all<index::built_in_subjects>, {"f32", "f64"},
     by_arithmetic, Call::index_f32, 30, "index"},
    {"micromap", {"micromap", "lossy"}, micromap::laws, all<micromap::built_in_subjects>, {"micromap"},
     one<micromap::plugin_subject>, Call::micromap_pack, 12},
    {"tree", {"tree", "paper"}, tree::laws, all<tree::built_in_subjects>, {"tree"},
     one<tree::plugin_subject>, Call::tree_encode, 16, "tree", &tree::dialogue},
    {"vq", {"vq", "vq2", "vq4"}, vq::laws, all<vq::built_in_subjects>, {"vq"},
     one<vq::plugin_subject>, Call::vq2_decode, 5, "vq"},
    {"bake", {"bake"}, bake::laws, all<bake::built_in_subjects>, {"bake"},
     one<bake::plugin_subject>, Call::bake, 12, "bake", &bake::dialogue},
    {"attribute", {"attribute", "paper"}, attribute::laws, all<attribute::built_in_subjects>, {"attribute"},
     one<attribute::plugin_subject>, Call::attribute_vertex_index, 16, "attribute"},
    {"traverse", {"traverse", "paper"}, traverse::laws, all<traverse::built_in_subjects>, {"traverse"},
     one<traverse::plugin_subject>, Call::traverse_decide, 0},
    {"array", {"array"}, array::laws, all<array::built_in_subjects>, {"array"},
     one<array::plugin_subject>, Call::array_build, 9, "array"},
    {"dag", {"dag"}, dag::laws, all<dag::built_in_subjects>, {"dag"},
     one<dag::plugin_subject>, Call::dag_encode, 12, "dag"},
    {"subdivision", {"subdivision"}, subdivision::laws, all<subdivision::built_in_subjects>, {"subdivision"},
     one<subdivision::plugin_subject>, Call::subdivision_index, 16, "subdivision"},
};
// clang-format on

}  // namespace

std::span<const Topic> topics() { return table; }

}  // namespace mmverify::proofs
