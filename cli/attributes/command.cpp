// The arguments of mmverify attributes.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/arguments/arguments.hpp"
#include "cli/attributes/attributes.hpp"
#include "cli/commands.hpp"
#include "cli/output/plot_file.hpp"

namespace mmverify::cli {
namespace {

void add_packing(CLI::App& command, AttributeArguments& arguments) {
  command.add_flag("--packed", arguments.packed,
                   "pack the maps as well, beside their entropy and what zstd makes of them");
  command.add_option("--files", arguments.files, "write the maps, packed, as FOLDER/SET_KIND_levelN.mmat")
      ->type_name("FOLDER");
  auto* const error =
      command
          .add_option("--packed-error", arguments.packed_error,
                      "the most that a packed code may be off; 0 is lossless; implies --packed")
          ->check(whole_within(0, 127))
          ->type_name("CODES");
  auto* const astc =
      command
          .add_flag("--astc", arguments.astc,
                    "compress the textures as ASTC, and give their sizes at the errors of lossless "
                    "maps; implies --packed, needs the program astcenc")
          ->excludes(error);
  command
      .add_flag("--bc7", arguments.bc7, "the same in BC7; needs the program bc7enc, of npm's @gpu-tex-enc/bc")
      ->excludes(error)
      ->excludes(astc);
}

}  // namespace

Action add_attributes(CLI::App& program) {
  auto* command = program.add_subcommand(
      "attributes",
      "measure micromaps of a scene's colours, normals and roughness: how many, how large, how far from the "
      "textures");
  auto arguments = std::make_shared<AttributeArguments>();
  command
      ->add_option(
          "file", arguments->file,
          "the scene; quad: two triangles with two textures; without it the suite's own, a plant and a fence")
      ->type_name("FILE.gltf|FILE.glb");
  command->add_option("--level", arguments->levels, "levels of the maps; 0..5 where not given")
      ->type_name("N|A..B");
  command->add_flag("--codes", arguments->codes,
                    "average codes, as the paper's pixels, not light and directions");
  add_packing(*command, *arguments);
  command->add_flag(
      "--time", arguments->time,
      "take the time of a lookup at random points, in the textures and in the maps; one thread");
  command->add_flag(
      "--mips", arguments->mips,
      "compare mips of the textures with those of the maps of the highest level, near the borders "
      "of an atlas's charts and inside; needs --level A..B");
  command
      ->add_option_function<std::string>(
          "--plan", [arguments](const std::string& text) { arguments->plan = parse_numbers(text); },
          "give each triangle the lowest of these levels whose faces, or vertices, keep an error, in codes "
          "of "
          "8 bits, and none where one value does; beside all of one level")
      ->check(each_finite_within(0, 255))
      ->type_name("RMSE[,RMSE...]");
  command
      ->add_option("--pictures", arguments->pictures,
                   "write each base colour beside its maps and their FLIP, a PNG a level")
      ->type_name("FOLDER");
  command
      ->add_option("--plot", arguments->plot, "draw errors against sizes, and with --time against run times")
      ->check(plot_name)
      ->type_name("FILE.svg|FILE.png");
  command->add_option("--json", arguments->json, "write the figures as JSON; - is stdout")
      ->type_name("FILE|-");
  command
      ->add_option("--threads", arguments->threads,
                   "worker threads; as many as the machine has where not given")
      ->check(whole_within(1, 1024));
  command->add_flag("--quiet", arguments->quiet, "no progress");
  return [arguments] { return measure_attributes(*arguments); };
}

}  // namespace mmverify::cli
