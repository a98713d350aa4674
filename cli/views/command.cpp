// The arguments of mmverify views.
#include <CLI/CLI.hpp>
#include <memory>

#include "cli/arguments/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/views/views.hpp"

namespace mmverify::cli {

Action add_views(CLI::App& program) {
  auto* command = program.add_subcommand("views",
                                         "render one view of a glTF scene with its textures and with "
                                         "attribute micromaps, and compare them by FLIP");
  auto arguments = std::make_shared<ViewArguments>();
  command
      ->add_option(
          "file", arguments->file,
          "the scene; quad: two triangles with two textures; without it the suite's own, a plant and a fence")
      ->type_name("FILE.gltf|FILE.glb");
  command->add_option("--level", arguments->levels, "levels of the maps; 0..6 where not given")
      ->type_name("N|A..B");
  command
      ->add_option_function<std::string>(
          "--shading",
          [arguments](const std::string& name) {
            arguments->shading = name == "lit"     ? render::Shading::lit
                                 : name == "unlit" ? render::Shading::unlit
                                                   : render::Shading::normals;
          },
          "lit, base colours as they are (unlit), or normals in the scene's space")
      ->check(CLI::IsMember({"lit", "unlit", "normals"}));
  auto* const cones = command->add_flag(
      "--cones", arguments->cones,
      "read maps at the level that each ray's cone asks for, too, beside a view of the textures "
      "with more rays");
  command
      ->add_option("--reference", arguments->reference,
                   "rays along each side of a pixel of that view; 4 where not given")
      ->check(whole_within(2, 8))
      ->needs(cones);
  command->add_option("--rays", arguments->rays, "rays along each side of a pixel; 1 where not given")
      ->check(whole_within(1, 8));
  command
      ->add_option("--pictures", arguments->pictures,
                   "write each view beside its textured one and FLIP's map, a PNG a level")
      ->type_name("FOLDER");
  command->add_option("--json", arguments->json, "write the figures as JSON; - is stdout")
      ->type_name("FILE|-");
  add_picture_size(*command, arguments->size);
  command->add_option("--camera", arguments->camera, "0: the whole scene; 1, 2, ...: of a random path")
      ->check(whole_within(0, 1'000'000'000));
  command->add_option("--seed", arguments->seed, "seed of the random path")->check(fits_64_bits);
  command->add_flag("--no-shadows", arguments->no_shadows, "primary rays alone");
  command
      ->add_option("--threads", arguments->threads,
                   "worker threads; as many as the machine has where not given")
      ->check(whole_within(1, 1024));
  command->add_flag("--quiet", arguments->quiet, "no progress");
  return [arguments] { return render_views(*arguments); };
}

}  // namespace mmverify::cli
