#include "proofs/bake/mutants/forgetful.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <thread>

namespace mmverify::proofs::bake {
namespace {

/// Takes one thing of a case from another case.
using Take = void (*)(Case& one, const Case& from);

/// A thread's last question, asked again where one differs from it in that thing alone.
std::function<void(Functions&)> forgetting(Take take) {
  return [take](Functions& functions) {
    struct Memory {
      std::mutex lock;
      std::map<std::thread::id, Case> last;
    };
    functions.bake = [take, memory = std::make_shared<Memory>(), real = functions.bake](
                         const Case& one, Level n, Format format) {
      Case asked = one;
      {
        const std::lock_guard hold(memory->lock);
        Case& last = memory->last[std::this_thread::get_id()];
        take(asked, last);
        if (asked != last) asked = one;
        last = asked;
      }
      return real(asked, n, format);
    };
  };
}

}  // namespace

std::vector<Mutant> forgetful_mutants() {
  struct Forgotten {
    const char* what;
    Take take;
  };
  const Forgotten all[] = {
      {"known but for the border", [](Case& one, const Case& from) { one.border = from.border; }},
      {"known but for the addressing of u", [](Case& one, const Case& from) { one.wrap_u = from.wrap_u; }},
      {"known but for the addressing of v", [](Case& one, const Case& from) { one.wrap_v = from.wrap_v; }},
      {"known but for the filter", [](Case& one, const Case& from) { one.filter = from.filter; }},
      {"known but for the factor", [](Case& one, const Case& from) { one.factor = from.factor; }},
      {"known but for the vertices' factor",
       [](Case& one, const Case& from) { one.vertex_factor = from.vertex_factor; }},
      {"known but for the alpha mode", [](Case& one, const Case& from) { one.blend = from.blend; }},
      {"known but for the cutoff", [](Case& one, const Case& from) { one.cutoff = from.cutoff; }},
      {"known but for the margin", [](Case& one, const Case& from) { one.margin = from.margin; }},
      {"known but for the first vertex", [](Case& one, const Case& from) { one.uv[0] = from.uv[0]; }},
      {"known but for the last vertex", [](Case& one, const Case& from) { one.uv[5] = from.uv[5]; }},
  };
  std::vector<Mutant> mutants;
  for (const Forgotten& one : all) mutants.push_back(mutant(one.what, "bake", {0, 6}, forgetting(one.take)));
  return mutants;
}

}  // namespace mmverify::proofs::bake
