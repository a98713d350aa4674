// Arrays as files: both versions read back the same, and other bytes are refused.
#include "proofs/array/cases.hpp"
#include "proofs/array/law_parts.hpp"
#include "proofs/array/laws.hpp"
#include "proofs/engine/shape.hpp"

namespace mmverify::proofs::array {
namespace {

constexpr std::uint64_t file_choices = 8;

/// One or two triangles of the 46 sorted maps of levels 0 and 1, with every choice of the small arrays; the encoding
/// changes from case to case.
std::uint64_t files() {
  const std::uint64_t sorted = sorted_maps(1).size();
  return (sorted + sorted * sorted) * file_choices;
}
Bundle file_number(std::uint64_t k) {
  const auto& from = sorted_maps(1);
  const std::uint64_t choice = k % file_choices, rest = k / file_choices;
  BuildCase c;
  c.options.api = Api::glTF;
  c.options.encoding = spec::micromap::encodings[k % 5];
  c.options.special = (choice & 1) == 0;
  c.options.share = (choice & 2) == 0;
  if ((choice & 4) != 0) {
    c.before = {{1, Format::four_state, {0xe4}}};
    c.options.base = 1;
  }
  if (rest < from.size())
    c.maps = {from[rest]};
  else
    c.maps = {from[(rest - from.size()) / from.size()], from[(rest - from.size()) % from.size()]};
  Bundle b = bundle_of(c);
  // Some bundles have two geometries, and some none.
  if (k % 7 == 0) b.parts.push_back({Encoding::u16, 3, {0xff, 0xff}});
  if (k % 11 == 0) b.parts.clear();
  return b;
}

bool fits_version_1(const Bundle& b) { return b.parts.size() == 1 && b.parts[0].encoding == Encoding::u32; }

Finding comes_back(const ArraySubject& s, const Bundle& b) {
  std::uint64_t digest = 0;
  for (const std::uint32_t version : {1u, 2u}) {
    if (version == 1 && !fits_version_1(b)) continue;
    const Bytes right = spec::array::written(b, version), file = s.functions.write(b, version);
    if (!s.functions.files_are_ours && version == 1 && file.empty()) continue;
    if (s.functions.files_are_ours && file != right)
      return wrong(fmt::format("version {}: {} bytes, {:016x}", version, right.size(), hash_of(right)),
                   fmt::format("{} bytes, {:016x}", file.size(), hash_of(file)));
    const auto back = s.functions.read(file);
    if (!back) return wrong(fmt::format("version {} is read", version), "refused");
    if (*back != b) return wrong(fmt::format("version {}: the array", version), "another one");
    digest = digest * 31 + hash_of(file);
  }
  return {digest};
}

/// Whether a bundle is an array by the C header: every plain index names a record; every record has a format, a level
/// up to 12 and its bytes in the data.  A reader may refuse a file with any other bundle.
bool is_array(const Bundle& b) {
  for (const Record& r : b.array.records) {
    if (r.level > 12 || (r.format != 1 && r.format != 2)) return false;
    const std::uint64_t bytes =
        spec::micromap::packed_bytes(spec::micromap::micro_triangles(r.level), static_cast<Format>(r.format));
    if (r.offset + bytes > b.array.data.size()) return false;
  }
  for (const Part& part : b.parts)
    for (std::uint64_t t = 0; t < spec::array::triangles(part); ++t)
      if (spec::array::target(b, part, t).kind == Target::Kind::outside) return false;
  return true;
}

/// Files with every cut, every bit flipped, and a byte appended.  They are read as the specification reads them; a
/// reader may also refuse a bundle that is no array.
Finding refuses(const ArraySubject& s, const Bundle& b) {
  std::uint64_t digest = 0;
  const auto same = [&](const Bytes& file, const std::string& what) -> std::optional<Finding> {
    const auto right = spec::array::read(file), got = s.functions.read(file);
    digest = digest * 31 + (right ? 1 : 0);
    if (right == got || (right && !got && !is_array(*right))) return std::nullopt;
    return wrong(what + (right ? ": read" : ": refused"), right && got ? "read as another"
                                                          : right      ? "refused"
                                                                       : "read");
  };
  for (const std::uint32_t version : {1u, 2u}) {
    if (version == 1 && !fits_version_1(b)) continue;
    const Bytes file = spec::array::written(b, version);
    for (std::size_t cut = 0; cut < file.size(); ++cut)
      if (auto found = same(Bytes(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(cut)),
                            fmt::format("version {} cut at {}", version, cut)))
        return *found;
    for (std::size_t bit = 0; bit < 8 * file.size(); ++bit) {
      Bytes other = file;
      other[bit / 8] = static_cast<std::uint8_t>(other[bit / 8] ^ 1u << bit % 8);
      if (auto found = same(other, fmt::format("version {} bit {} flipped", version, bit))) return *found;
    }
    Bytes longer = file;
    longer.push_back(0);
    if (auto found = same(longer, fmt::format("version {} and a byte", version))) return *found;
  }
  return {digest};
}

std::function<void(Functions&)> misreading(void (*change)(std::span<const std::uint8_t>,
                                                          std::optional<Bundle>&)) {
  return spoils(&Functions::read,
                [change](std::span<const std::uint8_t> file, std::optional<Bundle>& b) { change(file, b); });
}

/// The law of files on random arrays, drawn as for the laws of changes.
Law files_on_samples() {
  return on_cases(
      {.id = "array.files_on_samples",
       .says = "an array of any levels and geometries is saved and comes back",
       .source = here,
       .method = Method::sample,
       .subjects = {"array-spec", "array"},
       .tiers = {.fast = {0, 5}, .long_run = {0, 6}, .seconds = 0.2},
       .domain =
           [](Level n) {
             return fmt::format("the arrays of array.changes_on_samples, of levels up to {}", n);
           },
       .mutants = {mutant("data beyond 255 bytes loses its last one's high bit", "array", {0, 5},
                          misreading([](std::span<const std::uint8_t>, std::optional<Bundle>& b) {
                            if (b && b->array.data.size() > 255) b->array.data.back() &= 0x7f;
                          })),
                   mutant("a base triangle beside indices of 16 bits is one of the first geometry",
                          "array-spec", {0, 5},
                          misreading([](std::span<const std::uint8_t>, std::optional<Bundle>& b) {
                            if (b && b->parts.size() > 1 && b->parts[1].encoding == Encoding::u16)
                              b->parts[1].base = b->parts[0].base;
                          })),
                   mutant("an array with a map of level 4 is refused", "array", {2, 5},
                          misreading([](std::span<const std::uint8_t>, std::optional<Bundle>& b) {
                            if (b && std::any_of(b->array.records.begin(), b->array.records.end(),
                                                 [](const Record& r) { return r.level == 4; }))
                              b.reset();
                          }))}},
      {entry::file},
      drawn_cases(
          60,
          [](const ArraySubject& s, Level n, std::uint64_t seed, std::uint64_t k) {
            return comes_back(s, sample_bundle(n, seed, k));
          },
          16));
}

using FileCheck = Finding (*)(const ArraySubject&, const Bundle&);
Law on_files(Law law, const Entry& needed, std::uint64_t one_in, FileCheck check) {
  law.subjects = {"array-spec", "array"};
  law.source = here;
  law.tiers.fast = law.tiers.long_run = {1, 1};
  return on_cases(std::move(law), {needed},
                  {[one_in](Level n) { return n == 1 ? files() / one_in : 0; },
                   [=](const ArraySubject& s, Level, std::uint64_t k, const Run&) {
                     return check(s, file_number(k * one_in));
                   },
                   [=](Level, std::uint64_t k, const Run&) { return fmt::format("array:{}", k * one_in); },
                   [check](const ArraySubject& s, Level, const std::string& at) {
                     const Groups parts = groups_of(at, "array:([0-9]{1,9})");
                     if (!parts || std::stoull((*parts)[1]) >= files())
                       throw BadCase(fmt::format("'{:.60}': write array:K, K below {}", at, files()));
                     return check(s, file_number(std::stoull((*parts)[1])));
                   },
                   64});
}

/// A file is read as if its checksum were right.
void mend_checksum(Functions& f) {
  f.read = [real = f.read](std::span<const std::uint8_t> file) {
    auto b = real(file);
    if (b || file.size() < 24 || file[8] != 2) return b;
    Bytes mended(file.begin(), file.end());
    const std::uint32_t sum = spec::array::checksum(file.first(file.size() - 4));
    for (unsigned j = 0; j < 4; ++j) mended[mended.size() - 4 + j] = static_cast<std::uint8_t>(sum >> 8 * j);
    return real(mended);
  };
}

void let_a_byte_pass(Functions& f) {
  f.read = [real = f.read](std::span<const std::uint8_t> file) {
    auto b = real(file);
    return b || file.empty() ? b : real(file.first(file.size() - 1));
  };
}

void take_version_3(Functions& f) {
  f.read = [real = f.read](std::span<const std::uint8_t> file) {
    auto b = real(file);
    if (b || file.size() < 12 || file[8] != 3) return b;
    Bytes other(file.begin(), file.end());
    other[8] = 1;
    if (auto first = real(other)) return first;
    other[8] = 2;
    return real(other);
  };
}

}  // namespace

std::vector<Law> file_laws() {
  return {
      on_files(
          {.id = "array.files",
           .says = "an array is saved as its one file of either version, and comes back",
           .tiers = {.seconds = 0.5},
           .domain = "1 and 2 triangles of the sorted maps of levels 0 and 1, all encodings, "
                     "every choice, each record with bytes of its own, none to two geometries",
           .mutants = {mutant("the base triangle is lost in version 1", "array", {1, 1},
                              misreading([](std::span<const std::uint8_t> file, std::optional<Bundle>& b) {
                                if (b && file[8] == 1) b->parts[0].base = 0;
                              })),
                       mutant("signed indices come back unsigned", "array-spec", {1, 1},
                              misreading([](std::span<const std::uint8_t>, std::optional<Bundle>& b) {
                                for (Part& p : b->parts)
                                  if (p.encoding == Encoding::i16) p.encoding = Encoding::u16;
                              })),
                       mutant("writes no checksum", "array", {1, 1},
                              spoils(&Functions::write,
                                     [](const Bundle&, std::uint32_t version, Bytes& file) {
                                       if (version == 2)
                                         std::fill(file.end() - 4, file.end(), std::uint8_t{0});
                                     }))}},
          entry::file, 1, comes_back),
      on_files({.id = "array.malformed_files",
                .says = "a file that is cut, longer or changed in a bit is refused, or is the file of what "
                        "is read; one whose records or indices make no array may be refused, too",
                .tiers = {.seconds = 1},
                .domain = "1 of 97 of the arrays of array.files: every cut, every bit, a byte behind",
                .mutants = {mutant("the checksum is not looked at", "array", {1, 1}, mend_checksum),
                            mutant("bytes behind are let pass", "array-spec", {1, 1}, let_a_byte_pass),
                            mutant("version 3 is read as version 2", "array", {1, 1}, take_version_3)}},
               entry::our_file, 97, refuses),
      files_on_samples()};
}

}  // namespace mmverify::proofs::array
