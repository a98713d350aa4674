#include "subjects/dock/trusted.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>

#include "subjects/dock/load_error.hpp"
#include "subjects/dock/sanitizer.hpp"

namespace mmverify::dock {

const mmverify_subject_t& load_trusted(const std::string& library, const Options& options) {
  const Worker worker(library, options);
  if (const std::string runtime = runtime_to_load_first(library); !runtime.empty())
    throw CannotLoad(
        fmt::format("{}: it needs {} before all else, and times of it would mean little; hand over one that "
                    "is built without sanitizers",
                    library, runtime));
  const std::string file = std::filesystem::absolute(library).string();
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw CannotLoad(fmt::format("{}: {}", library, load_error(file)));
  using Get = const mmverify_subject_t* (*)();
  const auto get = reinterpret_cast<Get>(dlsym(handle, "mmverify_subject_v1"));
  if (get == nullptr || get() == nullptr)
    throw CannotLoad(fmt::format("{}: no mmverify_subject_v1", library));
  return *get();
}

}  // namespace mmverify::dock
