#include "proofs/drawing/canvas.hpp"

#include <fmt/format.h>

#include <sstream>

namespace mmverify::proofs::drawing {
namespace {

void set(pugi::xml_node node, const std::vector<std::pair<const char*, std::string>>& attributes) {
  for (const auto& [name, value] : attributes) node.append_attribute(name) = value.c_str();
}

}  // namespace

Canvas::Canvas(double w, double h, const std::string& title) {
  svg_ = document_.append_child("svg");
  svg_.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
  svg_.append_attribute("viewBox") = fmt::format("0 0 {:.0f} {:.0f}", w, h).c_str();
  svg_.append_attribute("width") = w;
  svg_.append_attribute("height") = h;
  svg_.append_attribute("font-family") = "sans-serif";
  svg_.append_attribute("role") = "img";
  svg_.append_child("title").text() = title.c_str();
  auto defs = svg_.append_child("defs");
  auto hatch = defs.append_child("pattern");
  set(hatch, {{"id", "hatch"},
              {"width", "7"},
              {"height", "7"},
              {"patternUnits", "userSpaceOnUse"},
              {"patternTransform", "rotate(45)"}});
  auto line = hatch.append_child("rect");
  set(line, {{"width", "3"}, {"height", "7"}, {"fill", vermilion}, {"fill-opacity", "0.75"}});
  auto ground = svg_.append_child("rect");
  set(ground, {{"width", "100%"}, {"height", "100%"}, {"fill", "#ffffff"}});
}

void Canvas::polygon(const std::vector<Pixel>& points, const std::string& fill, const std::string& stroke,
                     double stroke_width, double opacity, bool closed) {
  std::string text;
  for (const Pixel& p : points) text += fmt::format("{:.2f},{:.2f} ", p.x, p.y);
  auto node = svg_.append_child(closed ? "polygon" : "polyline");
  set(node, {{"points", text},
             {"fill", fill},
             {"fill-opacity", fmt::format("{}", opacity)},
             {"stroke", stroke},
             {"stroke-width", fmt::format("{}", stroke_width)},
             {"stroke-linejoin", "round"}});
}

void Canvas::rectangle(const Pixel& corner, double width, double height, const std::string& fill) {
  set(svg_.append_child("rect"), {{"x", fmt::format("{}", corner.x)},
                                  {"y", fmt::format("{}", corner.y)},
                                  {"width", fmt::format("{}", width)},
                                  {"height", fmt::format("{}", height)},
                                  {"fill", fill},
                                  {"shape-rendering", "crispEdges"}});
}

void Canvas::dot(const Pixel& p, double radius, const std::string& fill, const std::string& stroke) {
  auto node = svg_.append_child("circle");
  set(node, {{"cx", fmt::format("{:.2f}", p.x)},
             {"cy", fmt::format("{:.2f}", p.y)},
             {"r", fmt::format("{}", radius)},
             {"fill", fill},
             {"stroke", stroke},
             {"stroke-width", "2"}});
}

void Canvas::text(const Pixel& p, const std::string& words, double size, const std::string& fill,
                  const std::string& anchor, bool bold) {
  // The white halo keeps words readable on a hatched ground.
  auto node = svg_.append_child("text");
  set(node, {{"x", fmt::format("{:.2f}", p.x)},
             {"y", fmt::format("{:.2f}", p.y)},
             {"font-size", fmt::format("{}", size)},
             {"fill", fill},
             {"text-anchor", anchor},
             {"font-weight", bold ? "bold" : "normal"},
             {"paint-order", "stroke"},
             {"stroke", "#ffffff"},
             {"stroke-width", "3"}});
  node.text() = words.c_str();
}

std::string Canvas::str() const {
  std::ostringstream out;
  document_.save(out, "  ");
  return out.str();
}

}  // namespace mmverify::proofs::drawing
