// Replaces attributes.cpp in builds without texture encoders, such as WebAssembly.
#include "cli/exit_code.hpp"
#include "cli/scene/attributes.hpp"

namespace mmverify::cli {

int scene_attributes(const AttributeArguments&) {
  throw EnvironmentError("scene --attributes is not in this build; the native mmverify has it");
}

}  // namespace mmverify::cli
