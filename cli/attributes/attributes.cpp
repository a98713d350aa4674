#include "cli/attributes/attributes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "bench/scene/astcenc.hpp"
#include "bench/scene/attribute_mip_tables.hpp"
#include "bench/scene/attribute_plan_tables.hpp"
#include "bench/scene/attribute_tables.hpp"
#include "bench/scene/attribute_times.hpp"
#include "bench/scene/bc7enc.hpp"
#include "bench/scene/compressors.hpp"
#include "cli/arguments/arguments.hpp"
#include "cli/bench/tables.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/json_output.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/plot_file.hpp"
#include "cli/output/png_file.hpp"
#include "cli/output/streams.hpp"
#include "cli/scene/loaded.hpp"
#include "proofs/engine/interrupt.hpp"
#include "scene/attribute/measure.hpp"
#include "scene/attribute/mip_errors.hpp"
#include "scene/attribute/picture.hpp"
#include "scene/attribute/planned_maps.hpp"

namespace mmverify::cli {
namespace {

using namespace mmverify::scene;

/// The greatest width of a tile of a picture.
constexpr std::uint32_t longest_tile = 1024;

/// Writes pictures of levels as PNG files, and keeps a list of them.
class PictureFolder {
 public:
  explicit PictureFolder(std::string folder) : folder_(std::move(folder)) {}

  void write(const AttributePicture& picture) {
    const std::string stem = stem_of(picture.image, picture.set);
    levels_.push_back(
        {name(picture.set), stem, picture.level,
         write(side_by_side(picture, longest_tile), fmt::format("{}_level{}", stem, picture.level))});
  }

  void write(const MipPicture& picture) {
    const std::string stem = stem_of(picture.image, picture.set);
    mips_.push_back({name(picture.set), stem, picture.mip,
                     write(side_by_side(picture, longest_tile), fmt::format("{}_mip{}", stem, picture.mip))});
  }

  void name_in(bench::Result& result) const {
    if (!levels_.empty()) result.tables.push_back(bench::attribute_pictures_table(levels_));
    if (!mips_.empty()) result.tables.push_back(bench::attribute_mip_pictures_table(mips_));
  }

 private:
  /// Writes the picture and returns its path.
  std::string write(const RgbPicture& picture, const std::string& name) const {
    const auto path = std::filesystem::path(folder_) / (name + ".png");
    OutputFile file(path.string());
    commit_png(file, picture.width, picture.height, picture.rgb);
    return path.generic_string();
  }

  /// A file name made from an image's: letters, digits, '-' and '_' stay; a number is added if the name is
  /// taken.
  std::string stem_of(const ColourImage& image, AttributeSet set) {
    const auto known = stems_.find({&image, set});
    if (known != stems_.end()) return known->second;
    std::string stem = std::filesystem::path(image.name).stem().string();
    std::replace_if(
        stem.begin(), stem.end(),
        [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != '_'; }, '_');
    if (stem.empty()) stem = "image";
    std::string own = stem;
    for (unsigned k = 2; !taken_.insert(own).second; ++k) own = fmt::format("{}_{}", stem, k);
    return stems_[{&image, set}] = own;
  }

  std::string folder_;
  std::map<std::pair<const ColourImage*, AttributeSet>, std::string> stems_;
  std::set<std::string> taken_;
  std::vector<bench::AttributePictureFile> levels_;
  std::vector<bench::MipPictureFile> mips_;
};

/// Writes FOLDER/baseColor_faces_level3.mmat whole, by OutputFile.
void write_maps(const std::string& folder, const StoredAttributes& stored) {
  std::string set = name(stored.set);
  std::replace(set.begin(), set.end(), '+', '_');
  const impl::attribute::AttributeMaps& maps = stored.maps;
  const char* const kind = maps.at == impl::attribute::MapAt::faces ? "faces" : "vertices";
  if (stored.packed.empty() && !maps.codes.empty())
    throw UsageError(
        fmt::format("--files: {} of level {} has {} codes, and a file has less than 2^31; "
                    "take a lower --level",
                    set, maps.level, maps.codes.size()));
  const std::vector<std::uint8_t> bytes = write_attributes(maps, stored.packed);
  OutputFile file(
      (std::filesystem::path(folder) / fmt::format("{}_{}_level{}.mmat", set, kind, maps.level)).string());
  file.commit({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// The most errors in --plan: each is a plan of all triangles, kept until all are printed.
constexpr std::size_t most_plans = 16;

AttributeScene loaded_attributes(const std::string& file) {
  if (const auto made = generated_scene(file)) return load_attributes(made->name, made->bytes);
  if (std::error_code none; std::filesystem::is_directory(file, none))
    throw UsageError(
        fmt::format("{}: a folder of textures has no triangles of its own; name a glTF file", file));
  return load_attributes(file);
}

proofs::Levels levels_of(const std::string& text) {
  const proofs::Levels levels = parse_levels(text, "--level");
  if (levels.last > finest_attribute_level)
    throw UsageError(
        fmt::format("--level {}: attributes are measured up to level {}", text, finest_attribute_level));
  return levels;
}

void check(const AttributeArguments& arguments, const proofs::Levels& levels) {
  if (arguments.mips && levels.first == levels.last)
    throw UsageError("--mips: it needs --level A..B, A below B: maps of level B and their mips down to A");
  if (arguments.plan.size() > most_plans)
    throw UsageError(fmt::format("--plan: {} errors; at most {}, because each one plans every triangle",
                                 grouped(arguments.plan.size()), most_plans));
  refuse_same_file({{"the scene", arguments.file}, {"--json", arguments.json}, {"--plot", arguments.plot}});
}

/// The options of a measurement, without the receivers of its steps. Looks for the texture coders.
AttributeOptions options_of(const AttributeArguments& arguments, const proofs::Levels& levels) {
  AttributeOptions options{.first = levels.first, .last = levels.last, .threads = arguments.threads};
  options.averaging = arguments.codes ? Averaging::codes : Averaging::meaning;
  options.packed = arguments.packed || arguments.packed_error != 0 || arguments.astc || arguments.bc7;
  options.packed_error = static_cast<std::uint8_t>(arguments.packed_error);
  options.peer = bench::zstd_bytes;
  if (!arguments.files.empty())
    options.stored = [&arguments](const StoredAttributes& stored) { write_maps(arguments.files, stored); };
  options.stop = [] {
    if (proofs::interrupted()) throw proofs::Interrupted();
  };
  if (!arguments.quiet)
    options.progress = [](const std::string& what) { say(stderr, "attributes: {}\n", what); };
  if (arguments.astc)
    options.texture_coder =
        bench::astc_coder({.threads = options.threads, .progress = options.progress, .stop = options.stop});
  if (arguments.bc7)
    options.texture_coder =
        bench::bc7_coder({.threads = options.threads, .progress = options.progress, .stop = options.stop});
  return options;
}

/// Measures; if it is interrupted, prints the attributes that are measured by then.
AttributeFigures measured(const AttributeScene& scene, AttributeOptions options, std::FILE* out) {
  AttributeFigures done;
  std::size_t left = 0;
  options.so_far = [&](const AttributeFigures& figures, std::size_t others) {
    done = figures;
    left = others;
  };
  try {
    return measure(scene, options);
  } catch (const proofs::Interrupted&) {
    if (!done.sets.empty()) {
      print_result(out, bench::scene_attribute_tables(done, scene, options));
      say(out, "ended early: {} attribute{} not measured\n", left, left == 1 ? " is" : "s are");
    }
    throw;
  }
}

void tell_left_out(std::FILE* out, const AttributeScene& scene) {
  say(out, "{}: no triangle has a texture of an attribute: nothing to measure\n", scene.file);
  for (const AttributeLeftOut& left : scene.left_out)
    say(out, "  left out  mesh {} primitive {}, {} triangles: {}\n", left.mesh, left.primitive,
        left.triangles, left.why);
}

}  // namespace

int measure_attributes(const AttributeArguments& arguments) {
  const proofs::Levels levels = levels_of(arguments.levels);
  check(arguments, levels);
  JsonOutput json(arguments.json);
  std::optional<PlotFile> plot;
  if (!arguments.plot.empty()) plot.emplace(arguments.plot);
  need_folder("--pictures", arguments.pictures);
  need_folder("--files", arguments.files);
  const proofs::InterruptGuard guard;
  AttributeOptions options = options_of(arguments, levels);
  PictureFolder pictures(arguments.pictures);
  if (!arguments.pictures.empty())
    options.picture = [&pictures](const AttributePicture& picture) { pictures.write(picture); };
  const AttributeScene read = loaded_attributes(arguments.file);
  if (read.textures.empty()) {
    tell_left_out(json.text(), read);
    if (json.given() || plot) throw UsageError("--json, --plot: there is nothing to write");
    return complete;
  }
  bench::AttributeTimer timer(read, {});
  if (arguments.time) options.kept = [&timer](const SetMaps& maps) { timer.take(maps); };
  std::function<void(const MipPicture&)> mip_picture;
  if (!arguments.pictures.empty())
    mip_picture = [&pictures](const MipPicture& picture) { pictures.write(picture); };
  MipErrors mips(options, mip_picture);
  if (arguments.mips) options.atlas = [&mips](const AttributeAtlas& atlas) { mips.take(atlas); };
  const AttributeFigures figures = measured(read, options, json.text());
  bench::Result result = bench::scene_attribute_tables(figures, read, options);
  if (arguments.time) {
    result.tables.push_back(bench::attribute_times_table(timer.times()));
    if (auto panels = bench::error_against_time(figures, timer.times()); !panels.empty()) {
      constexpr int height_of_row = 450;
      result.drawn->rows.push_back(std::move(panels));
      result.drawn->height += height_of_row;
    }
  }
  if (!arguments.plan.empty())
    for (bench::Table& table :
         bench::attribute_plan_tables(figures, planned_maps(read, options, arguments.plan)))
      result.tables.push_back(std::move(table));
  if (arguments.mips) result.tables.push_back(bench::attribute_mips_table(mips.steps()));
  pictures.name_in(result);
  print_result(json.text(), result);
  if (plot) plot->commit(*result.drawn);
  json.write([&] { return result_json(result); });
  return complete;
}

}  // namespace mmverify::cli
