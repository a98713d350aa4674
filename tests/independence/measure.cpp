#include "tests/independence/measure.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <unordered_map>
#include <unordered_set>

#include "tests/independence/fields.hpp"

namespace mmverify::independence {
namespace {

constexpr std::size_t most_bits = 1024, most_fields = 256, words = most_bits / 64;
/// So many questions and values are kept: what a law shows, it shows long before.
constexpr std::size_t most_kept = 2'000'000;

/// The file: scripts/independence reads it.
struct Table {
  std::uint64_t questions, bits, fields;
  std::array<std::uint8_t, most_fields> of_fields;  ///< 1 has had two values; 2 has decided an answer alone
  /// seen[2 x + y][i] has bit j where bit i was x and bit j was y in one question.
  std::uint64_t seen[4][most_bits][words];
};

struct Field {
  std::size_t region;
  std::string part;
  std::unordered_map<std::uint64_t, std::array<std::uint64_t, 2>> known;  ///< of all others: value, answer
  bool has_first = false;
  std::uint64_t first = 0;
};

class Measure {
 public:
  void count(dock::Call entry, const Regions& question, const Region& answer) {
    const std::lock_guard guard(lock_);
    if (table_ == nullptr) open(entry, question);
    if (is_of_a_probe(question)) return;
    if (!asked_.insert(hash(question)).second || table_->questions == most_kept) return;
    ++table_->questions;
    count_bits(question);
    count_fields(question, hash({answer}));
  }

 private:
  /// The worker asks beside a law's questions some of other levels, the subject's highest one among them.
  static bool is_of_a_probe(const Regions& question) {
    static const char* const last = std::getenv("MMVERIFY_MEASURE_LEVEL");
    if (last == nullptr || question[0].parameter != "level") return false;
    std::uint32_t level = 0;
    std::memcpy(&level, question[0].at, sizeof level);
    return level > std::strtoul(last, nullptr, 10);
  }

  void open(dock::Call entry, const Regions& question) {
    const std::string name = std::getenv("MMVERIFY_MEASURE");
    const int file = ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (file < 0 || ftruncate(file, sizeof(Table)) != 0) throw std::runtime_error(name);
    void* at = mmap(nullptr, sizeof(Table), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    close(file);
    if (at == MAP_FAILED) throw std::runtime_error(name);
    table_ = static_cast<Table*>(at);
    std::ofstream names(name + ".names");
    for (std::size_t k = 0; k < question.size(); ++k) {
      const Region& r = question[k];
      const std::string its =
          std::string(r.parameter) + (r.member.empty() ? "" : ".") + std::string(r.member);
      for (const std::string& part : parts_of(r, entry)) {
        if (fields_.size() == most_fields) throw std::logic_error("more fields than a table has");
        fields_.push_back({k, part, {}});
        names << "field " << its << " " << part << "\n";
      }
      names << "bits " << its << "\n";
    }
    table_->fields = fields_.size();
    // A region has 128 bits, present or not, so that a bit's number is the same in every question.
    table_->bits = std::min(most_bits, question.size() * bits_of_region(question.size()));
  }
  /// The bits counted of each region: as many as fit, the same number for all.
  static std::size_t bits_of_region(std::size_t regions) {
    return std::min<std::size_t>(128, most_bits / regions / 8 * 8);
  }

  void count_bits(const Regions& question) {
    std::array<std::uint64_t, words> ones{}, there{};
    const std::size_t wide = bits_of_region(question.size());
    for (std::size_t k = 0; k < question.size(); ++k)
      for (std::size_t b = 0; b < std::min(wide, 8 * question[k].bytes); ++b) {
        const std::size_t bit = k * wide + b;
        there[bit / 64] |= std::uint64_t{1} << bit % 64;
        ones[bit / 64] |= std::uint64_t{question[k].at[b / 8] >> b % 8 & 1u} << bit % 64;
      }
    for (std::size_t i = 0; i < table_->bits; ++i) {
      if ((there[i / 64] >> i % 64 & 1) == 0) continue;
      const std::size_t x = ones[i / 64] >> i % 64 & 1;
      for (std::size_t w = 0; w < (table_->bits + 63) / 64; ++w) {
        table_->seen[2 * x][i][w] |= there[w] & ~ones[w];
        table_->seen[2 * x + 1][i][w] |= ones[w];
      }
    }
  }

  void count_fields(const Regions& question, std::uint64_t answer) {
    for (std::size_t f = 0; f < fields_.size(); ++f) {
      if ((table_->of_fields[f] & 2) != 0) continue;
      const Target t = target_of(question[fields_[f].region], fields_[f].part);
      if (t.at == nullptr || t.bytes > 8) continue;
      std::array<std::uint8_t, 8> value{}, whole{};
      for (std::size_t k = 0; k < t.bytes; ++k) {
        whole[k] = t.at[k];
        value[k] = t.at[k] & t.mask;
        t.at[k] = static_cast<std::uint8_t>(t.at[k] & ~t.mask);
      }
      const std::uint64_t rest = hash(question);
      std::copy_n(whole.begin(), t.bytes, t.at);
      std::uint64_t number = 0;
      std::memcpy(&number, value.data(), sizeof number);
      if (!fields_[f].has_first) fields_[f].has_first = true, fields_[f].first = number;
      if (fields_[f].first != number) table_->of_fields[f] |= 1;
      if (kept_ >= most_kept && !fields_[f].known.contains(rest)) continue;
      const auto [before, is_new] = fields_[f].known.try_emplace(rest, std::array{number, answer});
      kept_ += is_new ? 1 : 0;
      if (!is_new && before->second[0] != number && before->second[1] != answer) {
        table_->of_fields[f] |= 2;
        kept_ -= fields_[f].known.size();
        fields_[f].known.clear();
      }
    }
  }

  std::mutex lock_;
  Table* table_ = nullptr;
  std::vector<Field> fields_;
  std::unordered_set<std::uint64_t> asked_;  ///< many questions are put several times over
  std::size_t kept_ = 0;
};

}  // namespace

bool measures() {
  static const bool does = std::getenv("MMVERIFY_MEASURE") != nullptr;
  return does;
}

void measure(dock::Call entry, const Regions& question, const Region& answer) {
  static Measure all;
  all.count(entry, question, answer);
}

}  // namespace mmverify::independence
