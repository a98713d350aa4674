#include "proofs/traverse/rays/seen_by.hpp"

#include <charconv>

namespace mmverify::proofs::traverse {
namespace {

/// The number after `name` at the start of `rest`, which loses it and what ends it.
std::uint64_t number_in(std::string_view& rest, std::string_view name, std::string_view all) {
  const auto bad = [&] {
    return BadCase(fmt::format("'{:.100}': write seed=S,camera=C,x=X,y=Y,METHOD,level=N", all));
  };
  if (!rest.starts_with(name)) throw bad();
  rest.remove_prefix(name.size());
  std::uint64_t n = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), n);
  if (error != std::errc()) throw bad();
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  if (!rest.empty() && rest.front() != ',') throw bad();
  if (!rest.empty()) rest.remove_prefix(1);
  return n;
}

}  // namespace

const std::vector<Form>& forms() {
  static const std::vector<Form> all = [] {
    std::vector<Form> f;
    for (const render::Method method : render::methods) {
      if (method == render::Method::texture) continue;
      for (unsigned level = 0; level <= (render::has_levels(method) ? finest_sample_level : 0); ++level)
        f.push_back({method, level});
    }
    return f;
  }();
  return all;
}

std::uint64_t pixels_by_forms() { return std::uint64_t{picture_width} * picture_height * forms().size(); }

SeenBy numbered(std::uint64_t k, const Run& run) {
  SeenBy c;
  c.seed = run.seed;
  c.form = forms()[k % forms().size()];
  k /= forms().size();
  c.x = static_cast<std::uint32_t>(k % picture_width);
  c.y = static_cast<std::uint32_t>(k / picture_width % picture_height);
  c.camera = 1 + k / (picture_width * picture_height);
  return c;
}

std::string text_of(const SeenBy& c) {
  return fmt::format("seed={},camera={},x={},y={},{},level={}", c.seed, c.camera, c.x, c.y,
                     render::name_of(c.form.method), c.form.level);
}

SeenBy read_seen_by(const std::string& at) {
  std::string_view rest = at;
  SeenBy c;
  c.seed = number_in(rest, "seed=", at);
  c.camera = number_in(rest, "camera=", at);
  const std::uint64_t x = number_in(rest, "x=", at), y = number_in(rest, "y=", at);
  const auto comma = std::min(rest.find(','), rest.size());
  const auto method = render::method_of(rest.substr(0, comma));
  rest.remove_prefix(std::min(comma + 1, rest.size()));
  const std::uint64_t level = number_in(rest, "level=", at);
  if (x >= picture_width || y >= picture_height || !method || *method == render::Method::texture ||
      !rest.empty() || level > (render::has_levels(*method) ? finest_sample_level : 0))
    throw BadCase(fmt::format("'{:.100}': no such pixel, method or level", at));
  c.x = static_cast<std::uint32_t>(x);
  c.y = static_cast<std::uint32_t>(y);
  c.form = {*method, static_cast<unsigned>(level)};
  return c;
}

std::optional<impl::micromap::State> Looked::at(std::uint32_t geometry, std::uint32_t triangle,
                                                const render::Barycentrics& b) const {
  const auto state = subject_.functions.look({form_.method, form_.level, geometry, triangle, b});
  return state ? std::optional(static_cast<impl::micromap::State>(*state)) : std::nullopt;
}

std::function<std::optional<std::string>(const Subject&, Level)> needing_rays(std::vector<Entry> entries) {
  return [needed = needing(std::move(entries))](const Subject& s, Level n) -> std::optional<std::string> {
    if (auto why = needed(s, n)) return why;
    if (!render::has_embree()) return render::embree_text();
    return std::nullopt;
  };
}

}  // namespace mmverify::proofs::traverse
