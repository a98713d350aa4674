#include "subjects/dock/sanitizer.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>

namespace mmverify::dock {
namespace {

/// A file of this machine's word size, read in pieces; anything beyond its end reads as nothing.
class ElfFile {
 public:
  explicit ElfFile(const std::string& name) {
    std::ifstream in(name, std::ios::binary | std::ios::ate);
    if (!in || in.tellg() <= 0) return;
    bytes_.resize(static_cast<std::size_t>(in.tellg()));
    in.seekg(0);
    in.read(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
  }

  std::vector<std::string> needed() const {
    std::vector<std::string> names;
    const auto header = at<ElfW(Ehdr)>(0);
    if (!header || std::memcmp(header->e_ident, ELFMAG, SELFMAG) != 0 ||
        header->e_ident[EI_CLASS] != (sizeof(void*) == 8 ? ELFCLASS64 : ELFCLASS32))
      return names;
    std::uint64_t table = 0, count = 0;
    std::vector<std::uint64_t> offsets;  // names' offsets in the string table
    for (const auto& part : parts(*header)) {
      if (part.p_type != PT_DYNAMIC) continue;
      for (count = 0; count * sizeof(ElfW(Dyn)) < part.p_filesz; ++count) {
        const auto entry = at<ElfW(Dyn)>(part.p_offset + count * sizeof(ElfW(Dyn)));
        if (!entry || entry->d_tag == DT_NULL) break;
        if (entry->d_tag == DT_STRTAB) table = entry->d_un.d_ptr;
        if (entry->d_tag == DT_NEEDED) offsets.push_back(entry->d_un.d_val);
      }
    }
    // The table's place is an address; find the part of the file that is loaded there.
    for (const auto& part : parts(*header))
      if (part.p_type == PT_LOAD && table >= part.p_vaddr && table - part.p_vaddr < part.p_filesz)
        for (const std::uint64_t offset : offsets)
          names.push_back(text_at(part.p_offset + (table - part.p_vaddr) + offset));
    return names;
  }

 private:
  template <class Piece>
  std::optional<Piece> at(std::uint64_t offset) const {
    if (offset > bytes_.size() || bytes_.size() - offset < sizeof(Piece)) return std::nullopt;
    Piece piece;
    std::memcpy(&piece, bytes_.data() + offset, sizeof piece);
    return piece;
  }
  std::vector<ElfW(Phdr)> parts(const ElfW(Ehdr) & header) const {
    std::vector<ElfW(Phdr)> all;
    for (std::uint64_t k = 0; k < header.e_phnum; ++k)
      if (const auto part = at<ElfW(Phdr)>(header.e_phoff + k * header.e_phentsize)) all.push_back(*part);
    return all;
  }
  std::string text_at(std::uint64_t offset) const {
    return offset < bytes_.size() ? std::string(bytes_.c_str() + offset) : std::string();
  }

  std::string bytes_;
};

struct Setting {
  const char *name, *value;
};
/// Options of gcc's and clang's sanitizers. They start no symbolizer: a worker starts no process.
constexpr std::array<Setting, 3> settings{
    {{"ASAN_OPTIONS",
      "handle_segv=0:handle_sigbus=0:handle_abort=0:handle_sigfpe=0:handle_sigill=0:detect_leaks=0:abort_on_"
      "error=1:external_symbolizer_path="},
     {"UBSAN_OPTIONS", "halt_on_error=1:abort_on_error=1:print_stacktrace=0:external_symbolizer_path="},
     {"TSAN_OPTIONS", "halt_on_error=1:abort_on_error=1:handle_segv=0:external_symbolizer_path="}}};

}  // namespace

std::string runtime_to_load_first(const std::string& library) {
  for (const std::string& name : ElfFile(library).needed())
    for (const std::string_view runtime :
         {"libasan.so", "libtsan.so", "libclang_rt.asan", "libclang_rt.tsan"})
      if (name.starts_with(runtime)) return name;
  return {};
}

std::vector<std::string> worker_environment(const std::string& library) {
  std::vector<std::string> all;
  const std::string runtime = runtime_to_load_first(library);
  std::string preload = runtime;
  std::array<std::string, settings.size()> values;
  for (std::size_t k = 0; k < settings.size(); ++k) values[k] = settings[k].value;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const std::size_t equals = text.find('=');
    const std::string_view name = text.substr(0, equals);
    const auto value = [&] { return std::string(text.substr(equals + 1)); };
    bool ours = false;
    for (std::size_t k = 0; k < settings.size(); ++k)
      if (name == settings[k].name) ours = true, values[k] += ":" + value();
    if (name == "LD_PRELOAD" && !runtime.empty()) ours = true, preload += ":" + value();
    if (!ours) all.emplace_back(text);
  }
  for (std::size_t k = 0; k < settings.size(); ++k)
    all.push_back(fmt::format("{}={}", settings[k].name, values[k]));
  if (!runtime.empty()) all.push_back("LD_PRELOAD=" + preload);
  return all;
}

}  // namespace mmverify::dock
