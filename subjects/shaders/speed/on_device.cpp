#include "subjects/shaders/speed/on_device.hpp"

#include <dlfcn.h>

#include <algorithm>

#include "subjects/shaders/compile/includes.hpp"

namespace mmverify::shaders {

OnDevice::OnDevice(std::uint32_t device) : number_(device) {
  const std::string library = device_library();
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) throw NotAvailable(library + ": " + dlerror());
  const auto open = reinterpret_cast<OpenKernels*>(dlsym(handle, open_kernels_name));
  if (open == nullptr) throw NotAvailable(library + ": it times no kernels; build it again");
  const char* why = "";
  kernels_ = open(device, &why);
  if (kernels_ == nullptr) throw NotAvailable(why);
  limits_ = kernels_->limits();
}

std::vector<std::pair<std::string, std::string>> OnDevice::about() const {
  std::vector<std::pair<std::string, std::string>> facts;
  const std::string text = kernels_->runs_on();
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    if (const auto colon = line.find(": "); colon != std::string::npos)
      facts.emplace_back(line.substr(0, colon), line.substr(colon + 2));
    at = end + 1;
  }
  return facts;
}

void OnDevice::load(const std::string& file, const std::string& entry_point) {
  Compiled& compiled = compiled_[file + "@" + entry_point];
  if (compiled.manifest.modules.empty())
    compiled = compile({include_root() + "/shaders/" + file, entry_point, number_});
  const Module& module = compiled.manifest.modules.front();
  succeeded(kernels_->load(module.file.c_str(), module.function.c_str(), module.group_size),
            "loading a kernel");
}

void OnDevice::reserve(std::uint32_t binding, std::uint64_t bytes) {
  succeeded(kernels_->reserve(binding, bytes), "making a buffer; smaller --hits need less memory");
}

void OnDevice::write(std::uint32_t binding, const std::vector<std::uint8_t>& bytes) {
  succeeded(kernels_->write(binding, bytes.data(), bytes.size()), "writing to the device");
}

void OnDevice::fill(std::uint32_t binding, std::uint32_t word) {
  succeeded(kernels_->fill(binding, word), "filling a buffer");
}

std::vector<std::uint32_t> OnDevice::words(std::uint32_t binding, std::uint64_t first, std::uint64_t count) {
  std::vector<std::uint32_t> read(count);
  succeeded(kernels_->read(binding, first * sizeof read[0], read.data(), count * sizeof read[0]),
            "reading from the device");
  return read;
}

void OnDevice::dispatch(const PushConstants& constants) {
  succeeded(kernels_->dispatch(constants, 0, nullptr), "running a kernel");
}

std::vector<double> OnDevice::times(const PushConstants& constants, std::size_t runs) {
  std::vector<double> ns(runs);
  succeeded(kernels_->dispatch(constants, runs, ns.data()), "timing a kernel");
  return ns;
}

std::vector<double> OnDevice::copy_times(std::uint32_t from, std::uint32_t to, std::uint64_t bytes,
                                         std::size_t runs) {
  std::vector<double> ns(runs);
  succeeded(kernels_->copy(from, to, bytes, runs, ns.data()), "timing a copy");
  return ns;
}

void OnDevice::succeeded(bool did, const char* what) const {
  if (!did) throw DeviceFailed(std::string(what) + ": " + kernels_->why());
}

}  // namespace mmverify::shaders
