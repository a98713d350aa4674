// A codec's source as a subject of tests: compiled, with the entry points that it declares.
#pragma once

#include <dlfcn.h>

#include <cstring>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "proofs/codecs/laws.hpp"
#include "subjects/source/codec.hpp"
#include "tests/folder.hpp"

namespace mmverify::codec_test {

using proofs::codecs::Facts;
using proofs::codecs::Question;

inline std::string source_text(const std::string& file) {
  return tests::text_of(std::string(MMVERIFY_ROOT) + "/" + file);
}

/// A codec in a file of its own, compiled, and what it says of itself.
class Made {
 public:
  explicit Made(const std::string& text) {
    const std::string file = folder_ / "codec.c";
    std::ofstream(file) << text;
    codec = std::make_unique<source::Codec>(file, std::vector<std::string>{"-I" MMVERIFY_ROOT},
                                            proofs::codecs::texts());
    handle_ = dlopen(codec->library().c_str(), RTLD_NOW);
    if (handle_ == nullptr) throw std::runtime_error(dlerror());
    const auto* subject =
        reinterpret_cast<const mmverify_subject_t* (*)()>(dlsym(handle_, "mmverify_subject_v1"))();
    facts = {
        [subject](dock::Call call) {
          void* pointer = nullptr;
          std::memcpy(&pointer, reinterpret_cast<const char*>(subject) + dock::entry_point(call).offset,
                      sizeof pointer);
          return pointer != nullptr;
        },
        subject->flags, subject->max_level,
        [handle = handle_](const std::string& symbol) { return dlsym(handle, symbol.c_str()) != nullptr; }};
  }
  ~Made() { dlclose(handle_); }
  Made(const Made&) = delete;
  Made& operator=(const Made&) = delete;

  std::unique_ptr<source::Codec> codec;
  Facts facts;

 private:
  tests::Folder folder_;
  void* handle_;
};

inline source::HarnessCall call_of(const Question& q) {
  return {q.file, q.function, q.level, q.format, q.size};
}

inline bool no_prover() {
  try {
    Made made(source_text("tests/subjects/codecs/maps.c"));
    return false;
  } catch (const source::NotAvailable&) {
    return true;
  }
}

}  // namespace mmverify::codec_test
