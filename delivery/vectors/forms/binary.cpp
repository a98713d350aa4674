#include <stdexcept>

#include "delivery/vectors/forms/forms.hpp"

namespace mmverify::vectors {
namespace {

constexpr std::size_t form_version = 2, header_bytes = 128, entry_bytes = 64, name_bytes = 16,
                      version_bytes = 40;
/// The greatest minStorageBufferOffsetAlignment that Vulkan allows: each section can be bound by itself.
constexpr std::size_t alignment = 256;

void put(std::string& out, std::uint32_t word) {
  for (unsigned k = 0; k < 4; ++k) out += static_cast<char>(word >> 8 * k & 0xff);
}

/// The text, padded with at least one zero.
void put(std::string& out, std::string_view text, std::size_t bytes) {
  if (text.size() >= bytes) throw std::logic_error("vectors: too long a text: " + std::string(text));
  out.append(text).append(bytes - text.size(), '\0');
}

void pad_to(std::string& out, std::size_t multiple) {
  while (out.size() % multiple != 0) out += '\0';
}

std::uint8_t digit(char c) { return static_cast<std::uint8_t>(c <= '9' ? c - '0' : c - 'a' + 10); }

void put_hash(std::string& out, std::string_view hex) {
  for (std::size_t k = 0; k + 1 < hex.size(); k += 2)
    out += static_cast<char>(digit(hex[k]) << 4 | digit(hex[k + 1]));
}

/// Consecutive records of one size.
struct Section {
  std::string name;
  std::size_t record_bytes, records;
  std::string bytes;
};

std::vector<Section> sections(const Family& family) {
  std::vector<Section> all;
  for (const Table& table : family.tables) {
    std::string bytes;
    for (const std::uint32_t word : table.words) put(bytes, word);
    all.push_back({table.name, 4 * table.stride(), table.records(), std::move(bytes)});
  }
  all.push_back({"data", 1, family.data.size(), {family.data.begin(), family.data.end()}});
  std::string abouts;
  for (const std::string& about : family.abouts) put(abouts, about, longest_about + 1);
  all.push_back({"about", longest_about + 1, family.abouts.size(), std::move(abouts)});
  return all;
}

}  // namespace

std::string payload(const Family& family) {
  std::string all;
  for (const Section& section : sections(family)) all += section.bytes;
  return all;
}

std::string digest(const Family& family, const Provenance& made_by) {
  return made_by.sha256(payload(family));
}

std::string as_binary(std::span<const Family> families, const Provenance& made_by) {
  std::size_t entries = 0;
  for (const Family& family : families) entries += family.tables.size() + 2;
  std::string contents, body;
  const std::size_t end = header_bytes + entry_bytes * entries;
  const std::size_t first = (end + alignment - 1) / alignment * alignment;
  for (const Family& family : families)
    for (const Section& section : sections(family)) {
      put(contents, family.name, name_bytes);
      put(contents, section.name, name_bytes);
      for (const std::size_t word :
           {std::size_t{family.version}, section.record_bytes, section.records, first + body.size()})
        put(contents, static_cast<std::uint32_t>(word));
      put(contents, "", entry_bytes - 2 * name_bytes - 16);
      body += section.bytes;
      pad_to(body, alignment);
    }
  std::string rest = contents;
  rest.append(first - header_bytes - contents.size(), '\0').append(body);

  std::string out = "MMVECTOR";
  for (const std::size_t word : {form_version, entries, header_bytes, header_bytes + rest.size()})
    put(out, static_cast<std::uint32_t>(word));
  put(out, made_by.version, version_bytes);
  put_hash(out, made_by.spec_hash);
  put_hash(out, made_by.sha256(rest));
  return out + rest;
}

}  // namespace mmverify::vectors
