// mmverify paper: the papers' figures, tables and claims beside what is here.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bench/papers/page.hpp"
#include "bench/papers/pictures.hpp"
#include "cli/arguments/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/output/exit_code.hpp"
#include "cli/output/output_file.hpp"
#include "cli/output/plot_file.hpp"
#include "cli/output/streams.hpp"
#include "proofs/engine/interrupt.hpp"
#include "scene/write/png.hpp"

namespace mmverify::cli {
namespace {

namespace fs = std::filesystem;
namespace papers = bench::papers;

struct PaperOptions {
  std::string paper, item, figure, table, scenes, textures, folder;
  unsigned threads = 0;
  bool quiet = false;

  bool one_item() const { return !item.empty() || !figure.empty() || !table.empty(); }
};

/// The glTF files in and below a folder, in order of name.
std::vector<std::string> scenes_in(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
    if (const auto type = at->path().extension(); type == ".gltf" || type == ".glb")
      files.push_back(at->path().string());
  if (error) throw EnvironmentError(fmt::format("--scenes {}: {}", folder, error.message()));
  if (files.empty())
    throw EnvironmentError(fmt::format("--scenes {}: no .gltf and no .glb is in it", folder));
  std::sort(files.begin(), files.end());
  return files;
}

papers::Measured measured_for(const PaperOptions& options) {
  refuse_no_folder("--textures", options.textures);
  papers::Sources sources;
  if (!options.scenes.empty()) sources.scenes = scenes_in(options.scenes);
  sources.textures = options.textures;
  sources.threads = options.threads;
  const bool takes_long = !options.folder.empty() || !options.scenes.empty() || !options.textures.empty();
  if (takes_long && !options.quiet)
    sources.progress = [](const std::string& step) { say(stderr, "paper: {}\n", step); };
  sources.note = [](const std::string& note) { say(stderr, "paper: {}\n", note); };
  sources.stop = [] {
    if (proofs::interrupted()) throw proofs::Interrupted();
  };
  return papers::Measured(std::move(sources));
}

/// Whether an item is asked for: "--table 2" takes "table 2, units" as well, "--item 4" also "4 a" and "4 b".
bool asked(const papers::Item& item, const PaperOptions& options) {
  const auto begins = [&](const std::string& name) {
    return item.id == name || item.id.starts_with(name + ",") || item.id.starts_with(name + " ");
  };
  return (!options.figure.empty() && begins("figure " + options.figure)) ||
         (!options.table.empty() && begins("table " + options.table)) ||
         (!options.item.empty() && begins(options.item)) || !options.one_item();
}

void print(const std::vector<const papers::Paper*>& chosen, const PaperOptions& options,
           papers::Measured& measured) {
  bool found = false;
  for (const papers::Paper* paper : chosen)
    for (const papers::Item& item : paper->items) {
      if (!asked(item, options)) continue;
      found = true;
      say(stdout, "{}", papers::lines(*paper, item, measured));
    }
  if (found) return;
  std::string ids;
  for (const papers::Paper* paper : chosen)
    for (const papers::Item& item : paper->items) ids += (ids.empty() ? "" : "; ") + item.id;
  throw UsageError(fmt::format("paper: no such item; there are: {}", ids));
}

/// The bytes of a PNG; none where gnuplot is needed and missing, which is said.
std::optional<std::string> png_of(const papers::Drawn& drawn) {
  if (const auto* pixels = std::get_if<render::Picture>(&drawn.picture)) {
    const std::vector<unsigned char> bytes = mmverify::scene::png(pixels->width, pixels->height, pixels->rgb);
    return std::string(bytes.begin(), bytes.end());
  }
  try {
    return plotted_png(std::get<bench::picture::Picture>(drawn.picture));
  } catch (const EnvironmentError& error) {
    say(stderr, "paper: {} is left out: {}\n", drawn.name, error.what());
    return std::nullopt;
  }
}

/// Makes all pages before it writes the first file.
void write(const std::vector<const papers::Paper*>& chosen, const PaperOptions& options,
           papers::Measured& measured) {
  need_folder("-o", options.folder);
  std::vector<std::pair<std::string, std::string>> files;
  for (const papers::Paper* paper : chosen) {
    std::vector<papers::PictureLink> links;
    for (const papers::Drawn& drawn : papers::pictures(*paper, measured))
      if (const auto bytes = png_of(drawn)) {
        const std::string name = paper->id + "_" + drawn.name + ".png";
        files.emplace_back(name, *bytes);
        links.push_back({drawn.item, name, drawn.caption});
      }
    files.emplace_back(paper->id + ".md", papers::page(*paper, measured, links));
  }
  for (const auto& [name, text] : files) {
    OutputFile((fs::path(options.folder) / name).string()).commit(text);
    say(stdout, "{}\n", (fs::path(options.folder) / name).generic_string());
  }
}

int paper(const PaperOptions& options) {
  if (options.one_item() && !options.folder.empty())
    throw UsageError("paper: -o writes whole pages; leave --figure, --table and --item out");
  std::vector<const papers::Paper*> chosen;
  for (const papers::Paper& one : papers::all())
    if (options.paper.empty() || options.paper == one.id) chosen.push_back(&one);
  const proofs::InterruptGuard guard;
  papers::Measured measured = measured_for(options);
  try {
    if (options.folder.empty())
      print(chosen, options, measured);
    else
      write(chosen, options, measured);
  } catch (const std::invalid_argument& error) {
    throw EnvironmentError(fmt::format("paper: {}", error.what()));
  }
  return complete;
}

}  // namespace

Action add_paper(CLI::App& program) {
  auto* command = program.add_subcommand(
      "paper", "the papers' figures, tables and claims: their numbers beside ours, and why they differ");
  auto options = std::make_shared<PaperOptions>();
  command->add_option("paper", options->paper, "one of them; all where not given")
      ->check(CLI::IsMember({"som", "com", "cam", "khr", "csm"}));
  command->add_option("--figure", options->figure, "this figure alone")->type_name("N");
  command->add_option("--table", options->table, "this table alone")->type_name("N");
  command->add_option("--item", options->item, "this item alone, by the name that its line begins with")
      ->type_name("ID");
  command
      ->add_option("--scenes", options->scenes,
                   "measure the glTF files in a folder, not the suite's own scene")
      ->type_name("FOLDER");
  command
      ->add_option("--textures", options->textures,
                   "measure the alpha textures in a folder, not generated leaves")
      ->type_name("FOLDER");
  command->add_option("-o,--output", options->folder, "write a page a paper, with tables and pictures")
      ->type_name("FOLDER");
  command
      ->add_option("--threads", options->threads,
                   "worker threads; as many as the machine has where not given")
      ->check(whole_within(1, 1024));
  command->add_flag("--quiet", options->quiet, "no progress");
  return [options] { return paper(*options); };
}

}  // namespace mmverify::cli
