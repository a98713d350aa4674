#include "cli/prove/shader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/output/exit_code.hpp"
#include "proofs/registry/plugin.hpp"
#include "subjects/shaders/compile/compile.hpp"

namespace mmverify::cli {
namespace {

using namespace proofs;

std::vector<std::string> entry_points_of(const shaders::Compiled& made) {
  std::vector<std::string> all;
  for (const shaders::Module& m : made.manifest.modules)
    all.push_back(m.entry_point == "ranked_lookup" ? "tree_lookup" : m.entry_point);
  return all;
}

}  // namespace

bool is_shader(const std::string& name) { return shaders::shader_name(plugin_name(name).file).has_value(); }

double timeout_of(const std::string& name, std::optional<double> given) {
  constexpr double of_shaders = 60;
  return given.value_or(is_shader(name) ? of_shaders : dock::Options().timeout_seconds);
}

std::string with_device(const std::string& name, std::optional<std::uint32_t> device,
                        const std::optional<std::string>& entry_point) {
  const auto [file, kind] = plugin_name(name);
  auto shader = shaders::shader_name(file);
  if (!shader) return name;
  if (const auto all = shaders::entry_points();
      entry_point && std::find(all.begin(), all.end(), *entry_point) == all.end())
    throw UsageError(fmt::format("--entry: no entry point of shaders is called {:.60}; there are {}",
                                 *entry_point, fmt::join(all, ", ")));
  // The name's own device and entry point take precedence.
  if (!shader->device && device != 0u) shader->device = device;
  if (!shader->entry_point) shader->entry_point = entry_point;
  return shaders::to_text(*shader) + (kind.empty() ? "" : ":" + kind);
}

std::vector<SubjectPtr> of_shader(const std::string& name, double timeout_seconds,
                                  std::vector<RunsOn>* runs_on) {
  const auto [called, kind] = plugin_name(name);
  const shaders::ShaderName shader = *shaders::shader_name(called);
  if (std::error_code error; !std::filesystem::is_regular_file(shader.file, error))
    throw EnvironmentError(fmt::format("{}: {}", shader.file,
                                       std::filesystem::exists(shader.file, error)
                                           ? "a folder, pipe or device, and no file"
                                           : "no such file"));
  std::vector<std::string> entry_points;
  try {
    const shaders::Compiled made = shaders::compile(shader);
    entry_points = entry_points_of(made);
    dock::Options options;
    options.timeout_seconds = timeout_seconds;
    options.environment = {fmt::format("{}={}", shaders::manifest_variable, made.manifest_file)};
    options.called = called;
    options.fingerprint = made.fingerprint;
    options.keeps = made.files;
    std::vector<RunsOn> opened;
    const auto subjects = subjects_of(open_library(shaders::device_library(), options), kind, &opened);
    if (runs_on != nullptr)
      for (RunsOn& one : opened) {
        one.about.insert(one.about.end(), made.about.begin(), made.about.end());
        one.warnings = made.warnings;
        runs_on->push_back(one);
      }
    return subjects;
  } catch (const shaders::BadShader& why) {
    throw UsageError(why.what());
  } catch (const shaders::NotAvailable& why) {
    throw EnvironmentError(fmt::format("{}: {}", called, why.what()));
  } catch (const dock::NotHere& why) {
    return absent_subjects(called, entry_points, why.what());
  } catch (const dock::CannotLoad& why) {
    throw EnvironmentError(fmt::format("{}: {}", called, why.what()));
  }
}

}  // namespace mmverify::cli
