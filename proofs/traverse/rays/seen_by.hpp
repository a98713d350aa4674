// Pixels of cameras on a random path through the sample world, each seen by one form of its maps: the cases of the laws
// about rays.
#pragma once

#include "proofs/traverse/law_parts.hpp"
#include "proofs/traverse/rays/sample_world.hpp"

namespace mmverify::proofs::traverse {

inline constexpr std::uint32_t picture_width = 32, picture_height = 24;

/// A method's maps at a level; square maps have one.
struct Form {
  render::Method method = render::Method::flat;
  unsigned level = 0;
};
const std::vector<Form>& forms();

struct SeenBy {
  std::uint64_t seed = 1, camera = 1;
  std::uint32_t x = 0, y = 0;
  Form form;

  render::Camera seen_from() const {
    return render::on_path(SampleWorld::get().box(), seed, camera, 4.0f / 3);
  }
};

/// Cases of a camera.
std::uint64_t pixels_by_forms();
/// Case k: forms first, then pixels, then cameras from number 1 on.
SeenBy numbered(std::uint64_t k, const Run& run);

/// seed=S,camera=C,x=X,y=Y,METHOD,level=N
std::string text_of(const SeenBy& c);
/// And back.  Errors: BadCase.
SeenBy read_seen_by(const std::string& at);

/// The subject, asked as a ray tracer asks.
class Looked final : public render::Opacity {
 public:
  Looked(const TraverseSubject& subject, const Form& form) : subject_(subject), form_(form) {}
  std::optional<impl::micromap::State> at(std::uint32_t geometry, std::uint32_t triangle,
                                          const render::Barycentrics& b) const override;
  std::uint64_t bytes() const override { return 0; }

 private:
  const TraverseSubject& subject_;
  const Form form_;
};

/// needing(), and Embree.
std::function<std::optional<std::string>(const Subject&, Level)> needing_rays(std::vector<Entry> entries);

}  // namespace mmverify::proofs::traverse
