// Replaces worker.cpp on platforms without processes, such as WebAssembly. The subject is a script of the
// page or of Node.js: an object of functions on typed arrays; see delivery/wasm/package/README.md.
#include <emscripten.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "subjects/dock/broken.hpp"
#include "subjects/dock/clean_text.hpp"
#include "subjects/dock/worker.hpp"

// Module.subject is the object. Its functions have the entry points' names and take the level, the format if
// there is one, the arrays of numbers, and the array for the answer.
// clang-format off
EM_JS(int, mmverify_script_is, (const char* path), {
  return Module.subject && Module.subject.path === UTF8ToString(path) ? 1 : 0;
});
EM_JS(int, mmverify_script_has, (const char* name), {
  return typeof Module.subject[UTF8ToString(name)] === "function" ? 1 : 0;
});
EM_JS(int, mmverify_script_number, (const char* name, int otherwise), {
  const value = Module.subject[UTF8ToString(name)];
  return Number.isInteger(value) ? value : otherwise;
});
EM_JS(void, mmverify_script_text, (const char* name, char* to, int room), {
  stringToUTF8(String(Module.subject[UTF8ToString(name)] || ""), to, room);
});
EM_JS(int, mmverify_script_call, (const char* name, int level, int format, const int* inputs, int arrays, int kind, int output,
                                  int values, int floats, int count, char* message, int room), {
  const of = (heap, address, size, n) => new heap(HEAPU8.buffer.slice(address, address + size * n));
  const heap = [Float32Array, Float64Array, Uint32Array][kind];
  const numbers = [];
  for (let k = 0; k < arrays; ++k)
    numbers.push(of(heap, HEAP32[(inputs >> 2) + k], heap.BYTES_PER_ELEMENT, count));
  const answer = floats === 2 ? new Uint8Array(values * count) : floats === 1 ? new Float32Array(values * count)
                                                                              : new Uint32Array(values * count);
  new Uint8Array(answer.buffer).set(HEAPU8.subarray(output, output + answer.byteLength));
  try {
    const entry = UTF8ToString(name);
    const before = format < 0 ? [level] : [level, format];
    const returned = Module.subject[entry](...before, ...numbers, answer);
    if (returned && typeof returned.then === "function") throw new Error(entry + " returned a promise; it has to answer at once");
  } catch (error) {
    stringToUTF8(String(error && error.message || error), message, room);
    return 0;
  }
  HEAPU8.set(new Uint8Array(answer.buffer), output);
  return 1;
});
// clang-format on

namespace mmverify::dock {
namespace {

/// Whether a script can have the entry point: it takes elements in arrays, and no blob in the header's form.
bool of_scripts(const EntryPoint& e) { return e.signature.arrays != 0 && !e.signature.of_blob; }

/// Whether the entry point takes a format besides the level.
bool has_format(Call call) {
  return entry_point(call).topic != Topic::index && call != Call::attribute_weights_f32;
}

}  // namespace

// Stubs: there is no process that prints or needs bounds.
Printed::~Printed() = default;
Bounds bounds() { return {}; }

Worker::Worker(std::string library, const Options& options, Before before)
    : library_(std::move(library)),
      options_(options),
      layout_(64),
      asked_(std::move(before.asked)),
      loaded_before_(before.loaded),
      file_(before.file) {
  start();
}

Worker::~Worker() { stop(); }

void Worker::start() {
  if (mmverify_script_is(library_.c_str()) == 0)
    throw CannotLoad(
        fmt::format("{}: shared libraries need the native mmverify: WebAssembly has no processes. A script "
                    "of JavaScript will do",
                    library_));
  base_ = static_cast<std::byte*>(std::calloc(layout_.total(), 1));
  if (base_ == nullptr) throw NoResources("no memory for a subject");
  mailbox_ = new (base_) Mailbox{};
  Description& d = description_;
  mmverify_script_text("name", d.name, sizeof d.name);
  d.max_level = static_cast<std::uint32_t>(mmverify_script_number("maxLevel", 12));
  d.flags = static_cast<std::uint32_t>(mmverify_script_number("flags", 0)) | MMVERIFY_SINGLE_THREADED;
  bool any = false;
  for (std::size_t c = 0; c < calls; ++c) {
    d.has[c] = of_scripts(entry_points[c]) && mmverify_script_has(entry_points[c].name) != 0 ? 1 : 0;
    any |= d.has[c] != 0;
  }
  if (!any) throw CannotLoad(library_ + ": no function of it is named as an entry point, such as index_f32");
}

void Worker::stop() {
  std::free(base_);
  base_ = nullptr;
}

void Worker::ask(Call call, std::uint32_t level, std::uint64_t count, std::uint32_t format) {
  const EntryPoint& entry = entry_point(call);
  const Signature& s = entry.signature;
  const int kind = !s.of_points ? 2 : s.number_bytes == sizeof(double) ? 1 : 0;
  const int numbers = s.value_bytes == 1 ? 2 : s.answers_floats ? 1 : 0;
  const auto ask_some = [&](std::uint64_t from, std::uint64_t some, unsigned char before) {
    std::array<int, most_arrays> inputs{};
    for (std::size_t a = 0; a < s.arrays; ++a)
      inputs[a] = static_cast<int>(reinterpret_cast<std::uintptr_t>(input(call, a, count, from)));
    auto* out = const_cast<std::byte*>(answer(call, count, from));
    std::memset(out, before, some * entry.answer_bytes);
    return mmverify_script_call(
               entry.name, static_cast<int>(level), has_format(call) ? static_cast<int>(format) : -1,
               inputs.data(), static_cast<int>(s.arrays), kind,
               static_cast<int>(reinterpret_cast<std::uintptr_t>(out)),
               static_cast<int>(entry.answer_bytes / s.value_bytes), numbers, static_cast<int>(some),
               mailbox_->report.message, sizeof mailbox_->report.message) != 0;
  };
  for (std::uint64_t from = 0; from < count; from += batch_size) {
    options_.stop_if_asked();
    const std::uint64_t some = std::min<std::uint64_t>(batch_size, count - from);
    const std::size_t bytes = static_cast<std::size_t>(some) * entry.answer_bytes;
    // The question is asked twice, over different bytes: a missing or changing answer shows.
    if (ask_some(from, some, blank_again)) {
      const std::vector<std::byte> first(answer(call, count, from), answer(call, count, from) + bytes);
      if (ask_some(from, some, blank)) {
        const std::byte* second = answer(call, count, from);
        const auto differs = std::mismatch(first.begin(), first.end(), second).first;
        if (differs == first.end()) continue;
        const auto at = static_cast<std::size_t>(differs - first.begin());
        const bool unwritten = first[at] == std::byte{blank_again} && second[at] == std::byte{blank};
        throw Misbehaved{unwritten ? "left its output unwritten" : "non-deterministic, when asked again",
                         from + at / entry.answer_bytes, 1};
      }
    }
    const std::string what = fmt::format("threw an exception: {}", clean_text(mailbox_->report.message));
    for (std::uint64_t t = from; t < from + some; ++t)
      if (!ask_some(t, 1, blank)) throw Misbehaved{what, t, 1, false, true};
    throw Misbehaved{what, from, some};
  }
}

Reply Worker::ask(const Question&) { throw NoResources("a script has no entry points of maps and codes"); }

}  // namespace mmverify::dock
