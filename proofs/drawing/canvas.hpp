// A drawing that counterexamples are shown on, written as SVG.
#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

namespace mmverify::proofs::drawing {

// Okabe and Ito's colours: told apart by the colour-blind too; the wrong answer is hatched besides.
inline constexpr char blue[] = "#0072B2", vermilion[] = "#D55E00", grey[] = "#9a9a9a", ink[] = "#222222";

struct Pixel {
  double x, y;
};

/// Later shapes lie over earlier ones.  "url(#hatch)" is a fill as well.
class Canvas {
 public:
  Canvas(double width, double height, const std::string& title);

  void polygon(const std::vector<Pixel>& points, const std::string& fill, const std::string& stroke,
               double stroke_width, double opacity = 1, bool closed = true);
  /// From its corner left above; neighbours leave no seam.
  void rectangle(const Pixel& corner, double width, double height, const std::string& fill);
  void dot(const Pixel& p, double radius, const std::string& fill, const std::string& stroke);
  void text(const Pixel& p, const std::string& words, double size, const std::string& fill = ink,
            const std::string& anchor = "start", bool bold = false);

  std::string str() const;

 private:
  pugi::xml_document document_;
  pugi::xml_node svg_;
};

}  // namespace mmverify::proofs::drawing
