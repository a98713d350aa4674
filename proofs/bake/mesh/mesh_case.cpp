#include "proofs/bake/mesh/mesh_case.hpp"

#include <charconv>
#include <cmath>

#include "proofs/array/cases.hpp"
#include "proofs/bake/support.hpp"

namespace mmverify::proofs::bake {

Case on_triangle(const MeshCase& mesh, std::size_t triangle) {
  Case one = mesh.surface;
  for (std::size_t corner = 0; corner < 3; ++corner)
    for (std::size_t axis = 0; axis < 2; ++axis)
      one.uv[2 * corner + axis] = mesh.vertices[mesh.triangles[triangle][corner]][axis];
  return one;
}

MeshCase alone(const MeshCase& mesh, std::size_t triangle) {
  MeshCase one = mesh;
  one.vertices.clear();
  for (const std::uint32_t vertex : mesh.triangles[triangle]) one.vertices.push_back(mesh.vertices[vertex]);
  one.triangles = {{0, 1, 2}};
  if (!mesh.levels.empty()) one.levels = {mesh.levels[triangle]};
  return one;
}

array::BuildCase build_case(const MeshCase& mesh) {
  array::BuildCase c;
  c.options.api = mesh.api;
  c.options.encoding = mesh.encoding;
  c.maps.resize(mesh.triangles.size());
  return c;
}

namespace {

constexpr Level most_level = 12;
constexpr std::size_t most_vertices = 4096;

[[noreturn]] void bad_mesh(std::string_view part, const char* remedy) {
  throw BadCase(fmt::format("'{:.60}': {}", part, remedy));
}

/// The items of a mesh, taken out of a case's text.
class MeshItems {
 public:
  explicit MeshItems(const std::string& text) {
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t to = std::min(text.find(',', from), text.size());
      const std::string item = text.substr(from, to - from);
      from = to + 1;
      const std::size_t at = item.find('=');
      const std::string name = item.substr(0, at);
      if (at != std::string::npos && std::find(names.begin(), names.end(), name) != names.end()) {
        if (!items_.emplace(name, item.substr(at + 1)).second) bad_mesh(item, "each name once");
      } else {
        rest_ += (rest_.empty() ? "" : ",") + item;
      }
    }
  }

  const std::string& rest() const { return rest_; }
  bool has(const char* name) const { return items_.count(name) != 0; }
  const std::string& value(const char* name) const {
    const auto found = items_.find(name);
    if (found == items_.end()) bad_mesh(name, "a mesh has api, indices, format, vertices and triangles");
    return found->second;
  }
  std::vector<std::string> values(const char* name) const {
    std::vector<std::string> all;
    const std::string& text = value(name);
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t to = std::min(text.find(':', from), text.size());
      all.push_back(text.substr(from, to - from));
      from = to + 1;
    }
    return all;
  }
  std::vector<std::uint32_t> numbers(const char* name) const {
    std::vector<std::uint32_t> all;
    for (const std::string& text : values(name)) {
      std::uint32_t& value = all.emplace_back(0);
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc() || end != text.data() + text.size()) bad_mesh(text, "a whole number is due");
    }
    return all;
  }

 private:
  static constexpr std::array<std::string_view, 6> names{"api",      "indices",   "format",
                                                         "vertices", "triangles", "levels"};
  std::map<std::string, std::string> items_;
  std::string rest_;
};

void read_array(MeshCase& mesh, const MeshItems& items) {
  bool has_api = false, has_encoding = false;
  for (const array::Api api : spec::array::apis)
    if (items.value("api") == spec::array::requirements(api).name) mesh.api = api, has_api = true;
  for (const array::Encoding e : spec::micromap::encodings)
    if (items.value("indices") == array::name_of(e)) mesh.encoding = e, has_encoding = true;
  if (!has_api || !has_encoding || !spec::array::takes(mesh.api, mesh.encoding))
    bad_mesh(items.value("indices"), "write an API and indices that it takes, as api=khr,indices=u8");
  const std::string& format = items.value("format");
  if (format != "2" && format != "4") bad_mesh(format, "write format=2 or format=4");
  mesh.format = format == "2" ? spec::micromap::Format::two_state : spec::micromap::Format::four_state;
}

void read_triangles(MeshCase& mesh, const MeshItems& items) {
  const std::vector<std::string> uv = items.values("vertices");
  if (uv.size() % 2 != 0 || uv.size() > 2 * most_vertices)
    bad_mesh("vertices", "write vertices=U:V:U:V:..., up to 4096 of them");
  for (std::size_t k = 0; k < uv.size(); k += 2) {
    std::array<float, 2>& vertex = mesh.vertices.emplace_back();
    for (std::size_t axis = 0; axis < 2; ++axis) {
      char* end = nullptr;
      vertex[axis] = std::strtof(uv[k + axis].c_str(), &end);
      if (uv[k + axis].empty() || *end != 0 || !std::isfinite(vertex[axis]))
        bad_mesh(uv[k + axis], "write a finite number, best as C's %a");
    }
  }
  const std::vector<std::uint32_t> corners = items.numbers("triangles");
  if (corners.size() % 3 != 0 || corners.size() > 3 * most_vertices)
    bad_mesh("triangles", "write three vertices a triangle, up to 4096 triangles");
  for (std::size_t k = 0; k < corners.size(); k += 3) {
    for (std::size_t corner = k; corner < k + 3; ++corner)
      if (corners[corner] >= mesh.vertices.size())
        bad_mesh("triangles", "a vertex that the mesh does not have");
    mesh.triangles.push_back({corners[k], corners[k + 1], corners[k + 2]});
  }
}

}  // namespace

std::string text_of(const MeshCase& mesh) {
  std::string text = text_of(mesh.surface);
  text.resize(text.rfind(",uv="));
  text +=
      fmt::format(",api={},indices={},format={},vertices=", spec::array::requirements(mesh.api).name,
                  array::name_of(mesh.encoding), mesh.format == spec::micromap::Format::two_state ? 2 : 4);
  const char* between = "";
  for (const auto& vertex : mesh.vertices) {
    text += fmt::format("{}{:a}:{:a}", between, vertex[0], vertex[1]);
    between = ":";
  }
  text += ",triangles=";
  between = "";
  for (const auto& corners : mesh.triangles) {
    text += fmt::format("{}{}:{}:{}", between, corners[0], corners[1], corners[2]);
    between = ":";
  }
  between = ",levels=";
  for (const Level level : mesh.levels) {
    text += fmt::format("{}{}", between, level);
    between = ":";
  }
  return text;
}

MeshCase mesh_from(const std::string& text, Level n) {
  const MeshItems items(text);
  MeshCase mesh;
  mesh.level = n;
  read_array(mesh, items);
  read_triangles(mesh, items);
  if (items.has("levels")) {
    mesh.levels = items.numbers("levels");
    if (mesh.levels.size() != mesh.triangles.size())
      bad_mesh(items.value("levels"), "a level for each triangle");
    for (const Level level : mesh.levels)
      if (level > n || level > most_level) bad_mesh(items.value("levels"), "levels up to the case's own");
  }
  mesh.surface = case_from(items.rest() + ",uv=0:0:0:0:0:0");
  return mesh;
}

namespace {

/// The coordinate reflected at both ends of a range, as often as it takes.
float reflected(float x, float low, float high) {
  const double width = double{high} - low, period = 2 * width;
  double in = std::fmod(double{x} - low, period);
  if (in < 0) in += period;
  return std::clamp(static_cast<float>(low + (in > width ? period - in : in)), low, high);
}

}  // namespace

MeshCase fitted(const Support& support, MeshCase mesh, std::uint64_t salt) {
  mesh.surface.uv = {};
  if (support.bounded()) mesh.surface.uv.fill(support.uv_min);
  mesh.surface = fitted(support, std::move(mesh.surface), salt);
  mesh.surface.uv = {};
  if (!support.two_state) mesh.format = spec::micromap::Format::four_state;
  if (support.bounded())
    for (auto& vertex : mesh.vertices)
      for (float& x : vertex) x = reflected(x, support.uv_min, support.uv_max);
  return mesh;
}

}  // namespace mmverify::proofs::bake
