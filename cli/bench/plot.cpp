#include "cli/bench/plot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <memory>

#include "cli/arguments.hpp"
#include "cli/exit_code.hpp"

extern char** environ;

namespace mmverify::cli {
namespace {

using bench::Growth;
using bench::GrowthLaw;
using bench::IndexErrors;
using bench::IndexFigures;

// Pixels; the labels are placed by hand, so the panels are too.
constexpr double width = 1000, height = 940;
constexpr double letter = 7.1, line_height = 15;  // of the labels' font, measured generously

struct Panel {
  double left, right, top, bottom;  // of the axes, in pixels from the top left corner
  double x_least, x_most, y_least, y_most;
  bool log_x;

  double x(double value) const {
    const double at = log_x ? std::log(value / x_least) / std::log(x_most / x_least)
                            : (value - x_least) / (x_most - x_least);
    return left + at * (right - left);
  }
  double y(double value) const {
    return bottom - std::log(value / y_least) / std::log(y_most / y_least) * (bottom - top);
  }
};

struct Box {
  double left, right, top, bottom;
  bool meets(const Box& b) const {
    return left < b.right && b.left < right && top < b.bottom && b.top < bottom;
  }
};

/// Colour says the algorithm (Okabe and Ito's, safe for the colour-blind), shape the numbers.
struct Look {
  const char* colour;
  int shape;  // gnuplot's point types
};

Look look(const IndexFigures& f) {
  Look l{"#0072B2", 7};
  if (f.name.starts_with("step")) l.colour = "#D55E00";
  if (f.order == "rows") l.colour = "#AA4488";
  if (f.name.starts_with("impl") || f.name.ends_with("impl")) l.colour = "#009E73";
  if (f.numbers == "binary16") l.shape = 9;
  if (f.numbers == "binary64") l.shape = 4;
  if (f.numbers == "fixed point") l.shape = 13;
  if (f.numbers == "rational") l.shape = 11;
  if (f.name.ends_with("batched") || f.name.ends_with("sqrt")) l.shape = 6;
  return l;
}

double power_of_ten(double x, bool up) {
  const double exponent = std::log10(x);
  return std::pow(10.0, up ? std::ceil(exponent) : std::floor(exponent));
}

/// Sets the axes of a panel; everything else about it is already in the script.
std::string axes(const Panel& p) {
  return fmt::format(
      "set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}\n"
      "set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}\n"
      "set xrange [{:.6g}:{:.6g}]\nset yrange [{:.6g}:{:.6g}]\nset logscale y\n{}\n",
      p.left / width, p.right / width, 1 - p.top / height, 1 - p.bottom / height, p.x_least, p.x_most,
      p.y_least, p.y_most, p.log_x ? "set logscale x" : "unset logscale x");
}

/// The places that a label may take beside its mark, the nearest first.
std::vector<Box> places(double x, double y, double text_width) {
  std::vector<Box> all;
  const auto at = [&](double left, double middle) {
    all.push_back({left, left + text_width, middle - line_height / 2, middle + line_height / 2});
  };
  for (int ring = 0; ring < 12; ++ring) {
    const double away = ring * line_height;
    for (const double dy : {-away, away}) {
      at(x + 11, y + dy);
      at(x - 11 - text_width, y + dy);
      at(x - text_width / 2, y + dy + (dy < 0 ? -1 : 1) * line_height);
    }
  }
  return all;
}

struct Mark {
  const IndexFigures* subject;
  double x, y;  // pixels
};

/// A label beside each mark, off the other marks, labels and one line, with a thin line where it had to move.
std::string labels(const std::vector<Mark>& marks, const Panel& panel, double grid_line) {
  std::vector<Box> taken{{panel.left, panel.right, grid_line - 2, grid_line + 2}};
  for (const Mark& m : marks) taken.push_back({m.x - 7, m.x + 7, m.y - 7, m.y + 7});
  std::string script;
  for (const Mark& m : marks) {
    const double text_width = letter * static_cast<double>(m.subject->name.size());
    Box chosen{};
    for (const Box& box : places(m.x, m.y, text_width)) {
      chosen = box;
      const bool inside = box.left > panel.left + 4 && box.right < panel.right - 4 &&
                          box.top > panel.top + 2 && box.bottom < panel.bottom - 2;
      if (inside && std::none_of(taken.begin(), taken.end(), [&](const Box& b) { return b.meets(box); }))
        break;
    }
    taken.push_back(chosen);
    const double middle = (chosen.top + chosen.bottom) / 2;
    script += fmt::format("set label '{}' at screen {:.5f},{:.5f} left font ',12' tc rgb '{}'\n",
                          m.subject->name, chosen.left / width, 1 - middle / height, look(*m.subject).colour);
    if (std::abs(middle - m.y) > line_height)
      script += fmt::format(
          "set arrow from screen {:.5f},{:.5f} to screen {:.5f},{:.5f} nohead lw 0.7 lc rgb '#888888'\n",
          m.x / width, 1 - m.y / height, std::clamp(m.x, chosen.left, chosen.right) / width,
          1 - (middle < m.y ? chosen.bottom - 2 : chosen.top + 2) / height);
  }
  return script;
}

/// "16", or "16 (binary16: 15)" where subjects end sooner than others.
std::string levels_text(const std::vector<IndexFigures>& figures) {
  std::uint32_t last = 0;
  for (const IndexFigures& f : figures)
    if (!f.hard.empty()) last = std::max(last, f.hard.back().level);
  std::string text = fmt::format("{}", last);
  for (const IndexFigures& f : figures)
    if (!f.hard.empty() && f.hard.back().level < last)
      return text + fmt::format(" ({}: {})", f.numbers, f.hard.back().level);
  return text;
}

std::string error_against_time(const std::vector<IndexFigures>& figures, std::uint64_t samples) {
  double ns_least = 1, ns_most = 1, rate_least = 1;
  std::uint64_t fewest = samples;
  for (const IndexFigures& f : figures) {
    if (f.times.empty() || f.hard.empty()) continue;
    ns_least = std::min(ns_least, f.times.back().ns_per_index);
    ns_most = std::max(ns_most, f.times.back().ns_per_index);
    if (f.hard.back().mismatches > 0) rate_least = std::min(rate_least, f.hard.back().rate());
    fewest = std::min(fewest, f.hard.back().samples);
  }
  // Nothing found is no point on a logarithmic axis: it gets a line of its own, below all that could be
  // found.
  const double none = power_of_ten(std::min(1.0 / static_cast<double>(samples), rate_least), false);
  const Panel panel{
      80,        970, 50,  420, power_of_ten(ns_least * 0.8, false), power_of_ten(ns_most * 2, true),
      none / 30, 1.5, true};

  std::vector<Mark> marks;
  for (const IndexFigures& f : figures) {
    if (f.times.empty() || f.hard.empty()) continue;
    const IndexErrors& e = f.hard.back();
    marks.push_back({&f, panel.x(f.times.back().ns_per_index), panel.y(e.mismatches > 0 ? e.rate() : none)});
  }
  std::stable_sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) { return a.x < b.x; });
  // Height means nothing on that line: marks that would hide one another are stacked there.
  for (std::size_t k = 1; k < marks.size(); ++k)
    for (std::size_t other = 0; other < k; ++other)
      if (marks[k].subject->hard.back().mismatches == 0 && std::abs(marks[k].x - marks[other].x) < 13 &&
          std::abs(marks[k].y - marks[other].y) < 13)
        marks[k].y = marks[other].y - 13;

  std::string script = axes(panel);
  script += fmt::format("set title 'Error against time at level {}'\n", levels_text(figures));
  script += "set xlabel 'ns an index, one thread' offset 0,0.4\nset ylabel 'mismatch rate on hard points'\n";
  script += "set format x '10^{%L}'\nset xtics auto\nunset key\nset mytics 1\n";
  script += fmt::format("set ytics ('none' {:.6g}", none);
  for (double tic = none * 10; tic < 2; tic *= 10)
    script += fmt::format(", '10^{{{:.0f}}}' {:.6g}", std::log10(tic), tic);
  script += ")\n";
  script += fmt::format(
      "set label 'none found in {} points (rational: {})' at screen {:.5f},{:.5f} right font ',12' "
      "tc rgb '#444444'\n",
      grouped(samples), grouped(fewest), (panel.right - 8) / width, 1 - (panel.bottom - 18) / height);
  for (const Mark& m : marks) {
    const Look l = look(*m.subject);
    script += fmt::format("set label '' at screen {:.5f},{:.5f} point pt {} ps 1.3 lw 2 lc rgb '{}'\n",
                          m.x / width, 1 - m.y / height, l.shape, l.colour);
  }
  script += labels(marks, panel, panel.y(none));
  return script + "plot 1/0 notitle\nunset label\nunset arrow\nset ytics auto\n";
}

/// The fitted law over the levels it was fitted on, for plotting.
std::string law_curve(const Growth& g) {
  if (g.law == GrowthLaw::none || g.law == GrowthLaw::too_few) return "";
  const std::string within = fmt::format("(x > {} - 0.05 && x < {} + 0.05)", g.first, g.last);
  const std::string value =
      g.law == GrowthLaw::power
          ? fmt::format("2**({:.6f})*x**({:.6f})", g.power.intercept, g.power.slope)
          : fmt::format("2**({:.6f}+({:.6f})*x)", g.exponential.intercept, g.exponential.slope);
  return fmt::format("{} ? {} : 1/0", within, value);
}

bool ever_wrong(const IndexFigures& f) {
  const auto wrong = [](const IndexErrors& e) { return e.mismatches > 0; };
  return std::any_of(f.hard.begin(), f.hard.end(), wrong) ||
         std::any_of(f.uniform.begin(), f.uniform.end(), wrong);
}

std::string rate_against_level(const std::vector<IndexFigures>& figures, bool hard, std::uint64_t samples) {
  std::uint32_t first = 16, last = 0;
  for (const IndexFigures& f : figures)
    for (const IndexErrors& e : f.hard) first = std::min(first, e.level), last = std::max(last, e.level);
  const double left = hard ? 550 : 80;
  const Panel panel{left,
                    left + 420,
                    510,
                    800,
                    first - 0.5,
                    last + 0.5,
                    power_of_ten(1.0 / static_cast<double>(samples), false) / 2,
                    1.5,
                    false};

  std::string data, plots;
  int number = 0;
  for (const IndexFigures& f : figures) {
    const std::vector<IndexErrors>& levels = hard ? f.hard : f.uniform;
    const Growth& growth = hard ? f.hard_rate : f.uniform_rate;
    // Asked of both kinds of points, so that the panels share one key.
    if (!ever_wrong(f)) continue;
    const std::string block = fmt::format("${}{}", hard ? "hard" : "uniform", number++);
    data += block + " << EOD\n-1 1\n";
    for (const IndexErrors& e : levels)
      if (e.mismatches > 0) data += fmt::format("{} {:.6g}\n", e.level, e.rate());
    data += "EOD\n";
    const Look l = look(f);
    plots += fmt::format("{}{} with points pt {} ps 0.9 lw 1.5 lc rgb '{}' title '{}'",
                         plots.empty() ? "" : ", ", block, l.shape, l.colour, f.name);
    if (const std::string curve = law_curve(growth); !curve.empty())
      plots += fmt::format(", {} with lines lw 1 lc rgb '{}' notitle", curve, l.colour);
  }
  std::string script = data + axes(panel);
  script +=
      fmt::format("set title 'On {} points, with the fitted laws'\nset xlabel 'level'\nset ylabel '{}'\n",
                  hard ? "hard" : "uniform", hard ? "" : "mismatch rate");
  script += "set format x '%g'\nset format y '10^{%L}'\nset xtics 1\nset samples 161\n";
  script += hard ? "unset key\n"
                 : fmt::format(
                       "set key at screen 0.5,{:.5f} center center vertical Left reverse maxrows 2 "
                       "width 3 samplen 1\n",
                       65 / height);
  return script + (plots.empty() ? "plot 1/0 notitle\n" : "plot " + plots + "\n");
}

std::string without_error(const std::vector<IndexFigures>& figures) {
  std::string names;
  for (const IndexFigures& f : figures)
    if (!ever_wrong(f)) names += (names.empty() ? "" : ", ") + f.name;
  return names.empty() ? "" : "none found at any level: " + names;
}

struct Closes {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closes>;

File temporary() {
  File file(std::tmpfile());
  if (!file) throw EnvironmentError(fmt::format("gnuplot: no temporary file: {}", std::strerror(errno)));
  return file;
}

std::string contents(const File& file) {
  std::rewind(file.get());
  std::string text;
  std::array<char, 4096> part;
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), file.get()))
    text.append(part.data(), n);
  return text;
}

}  // namespace

std::string index_plot_script(const std::vector<IndexFigures>& figures, std::uint64_t samples) {
  std::string script = fmt::format(
      "set terminal svg size {:.0f},{:.0f} font 'sans-serif,13' background rgb 'white'\n"
      "set multiplot\nset border lc rgb '#444444'\nset tics nomirror\n"
      "set grid lc rgb '#dddddd' lw 0.5\n",
      width, height);
  script += error_against_time(figures, samples);
  script += rate_against_level(figures, false, samples);
  // Drawn with the last panel, below all three.
  script += fmt::format("set label '{}' at screen 0.5,{:.5f} center font ',12' tc rgb '#444444'\n",
                        without_error(figures), 25 / height);
  script += rate_against_level(figures, true, samples);
  return script + "unset multiplot\n";
}

std::string run_gnuplot(const std::string& script) {
  // Files, not pipes: neither side can wait for the other.
  const File in = temporary(), out = temporary(), complaints = temporary();
  if (std::fwrite(script.data(), 1, script.size(), in.get()) != script.size() || std::fflush(in.get()) != 0)
    throw EnvironmentError(fmt::format("gnuplot: its script cannot be written: {}", std::strerror(errno)));
  std::rewind(in.get());

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, fileno(in.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(complaints.get()), STDERR_FILENO);
  char program[] = "gnuplot";
  char* const arguments[] = {program, nullptr};
  pid_t child = 0;
  const int spawned = posix_spawnp(&child, program, &files, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&files);
  if (spawned == ENOENT)
    throw EnvironmentError("--plot needs gnuplot, which is not here: install the Debian package gnuplot-nox");
  if (spawned != 0) throw EnvironmentError(fmt::format("gnuplot: {}", std::strerror(spawned)));

  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw EnvironmentError(fmt::format("gnuplot: {}", std::strerror(errno)));
  std::string picture = contents(out);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || picture.find("</svg>") == std::string::npos)
    throw EnvironmentError(fmt::format("gnuplot drew nothing: {}", contents(complaints)));
  return picture;
}

}  // namespace mmverify::cli
