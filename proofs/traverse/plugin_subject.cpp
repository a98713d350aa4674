#include "proofs/traverse/plugin_subject.hpp"

#include <fmt/format.h>

#include "dock/elements.hpp"
#include "proofs/traverse/combinations.hpp"
#include "proofs/traverse/words.hpp"
#include "sdk/mmverify_subject.h"

namespace mmverify::proofs::traverse {
namespace {

using dock::Call;
using dock::LibraryPtr;

static_assert(static_cast<std::uint32_t>(Api::ext_pipeline) == MMVERIFY_EXT_PIPELINE);
static_assert(static_cast<std::uint32_t>(Api::dxr_query) == MMVERIFY_DXR_QUERY);
static_assert(static_cast<std::uint32_t>(Outcome::non_opaque) == MMVERIFY_NON_OPAQUE);

Functions functions_of(const LibraryPtr& library) {
  Functions f;
  if (library->offers(Call::traverse_decide))
    f.decide = [library](const Combination& c) {
      const Words w = words_of(c);
      std::uint8_t code = 0;
      dock::ask_all(*library,
                    {Call::traverse_decide,
                     0,
                     static_cast<std::uint32_t>(c.api),
                     {&w.candidate, &w.instance, &w.ray},
                     [&](std::size_t) { return text_of(c); }},
                    1, &code);
      return static_cast<Outcome>(code);  // one that is none is wrong, and named by its number
    };
  return f;
}

}  // namespace

TraverseSubjectPtr plugin_subject(const std::string& name, const LibraryPtr& library) {
  if (!library->offers(dock::Topic::traverse)) return nullptr;
  return std::make_shared<TraverseSubject>(name, library->about(), functions_of(library),
                                           library->fingerprint());
}

}  // namespace mmverify::proofs::traverse
