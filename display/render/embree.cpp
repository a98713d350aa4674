#include "display/render/embree.hpp"

#include <dlfcn.h>

#include <type_traits>

namespace mmverify::render {

#define MMVERIFY_EMBREE_POINTER(name) decltype(&::name) name = nullptr;
MMVERIFY_EMBREE_FUNCTIONS(MMVERIFY_EMBREE_POINTER)
#undef MMVERIFY_EMBREE_POINTER

namespace {

std::string opened() {
  const std::string remedy = "; install Embree 3 (Debian: libembree3-3, or mmverify-plugins beside mmverify)";
  void* const library = dlopen(MMVERIFY_EMBREE_SONAME, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return std::string("no Embree: ") + dlerror() + remedy;
  const char* missing = nullptr;
  const auto find = [&](auto& pointer, const char* function) {
    pointer = reinterpret_cast<std::remove_reference_t<decltype(pointer)>>(dlsym(library, function));
    if (pointer == nullptr) missing = function;
  };
#define MMVERIFY_EMBREE_FIND(name) find(name, #name);
  MMVERIFY_EMBREE_FUNCTIONS(MMVERIFY_EMBREE_FIND)
#undef MMVERIFY_EMBREE_FIND
  if (missing != nullptr)
    return std::string("no Embree: " MMVERIFY_EMBREE_SONAME " has no ") + missing + remedy;
  return {};
}

}  // namespace

const std::string& why_no_embree() {
  static const std::string why = opened();
  return why;
}

}  // namespace mmverify::render
