#include "proofs/subdivision/cases.hpp"
#include "subjects/dock/elements.hpp"
#include "subjects/sdk/mmverify_subject.h"

namespace mmverify::proofs::subdivision {
namespace {

using dock::Call;
using dock::LibraryPtr;

static_assert(static_cast<std::uint32_t>(Scheme::triangle_4) == MMVERIFY_TRIANGLE_4);
static_assert(static_cast<std::uint32_t>(Scheme::tetrahedron) == MMVERIFY_TETRAHEDRON);
static_assert(static_cast<std::uint32_t>(Scheme::bisection) == MMVERIFY_BISECTION);

Functions functions_of(const LibraryPtr& library) {
  Functions f;
  f.max_level = library->description().max_level;
  if (library->offers(Call::subdivision_index))
    f.index = [library](Scheme scheme, Level n, const Fractions& p) -> std::uint64_t {
      std::uint32_t index = 0;
      dock::ask_all(*library,
                    {Call::subdivision_index,
                     n,
                     static_cast<std::uint32_t>(scheme),
                     {&p.numerators[0], &p.numerators[1], &p.numerators[2], &p.denominator},
                     [&](std::size_t) {
                       return text_of(Placed{scheme, n, p});
                     }},
                    1, &index);
      return index;
    };
  if (library->offers(Call::subdivision_corners))
    f.corners = [library](Scheme scheme, Level n, std::uint64_t k) {
      const auto index = static_cast<std::uint32_t>(k);
      std::array<std::uint32_t, 12> words{};
      dock::ask_all(*library,
                    {Call::subdivision_corners,
                     n,
                     static_cast<std::uint32_t>(scheme),
                     {&index},
                     [&](std::size_t) {
                       return text_of(Indexed{scheme, n, k});
                     }},
                    1, words.data());
      Corners<Whole> corners{};
      for (std::size_t word = 0; word < words.size(); ++word) corners[word / 3][word % 3] = words[word];
      return corners;
    };
  return f;
}

}  // namespace

SubdivisionSubjectPtr plugin_subject(const std::string& name, const LibraryPtr& library) {
  if (!library->offers(dock::Topic::subdivision)) return nullptr;
  return std::make_shared<SubdivisionSubject>(name, library->about(), functions_of(library),
                                              library->fingerprint());
}

}  // namespace mmverify::proofs::subdivision
