#include "bench/tree/sdsl.hpp"

#include <sdsl/bit_vectors.hpp>
#include <sdsl/rank_support_v5.hpp>
#include <set>
#include <utility>
#include <vector>

namespace mmverify::bench {

using impl::tree::Format;
using impl::tree::Level;

struct SdslTree::Sequences {
  sdsl::bit_vector nodes;
  sdsl::rank_support_v5<1> rank;
  sdsl::int_vector<> leaves;
  std::uint64_t internal = 0;
  Level n = 0;

  std::uint8_t find(std::uint32_t index) const {
    std::uint64_t p = 0;
    for (std::uint32_t shift = 2 * n; shift > 0;) {
      const std::uint64_t before = rank(p);
      if (!nodes[p]) return static_cast<std::uint8_t>(leaves[p - before]);
      shift -= 2;
      p = 4 * before + 1 + (index >> shift & 3);
    }
    // The node has depth n, and every internal node comes before it.
    return static_cast<std::uint8_t>(leaves[p - internal]);
  }
};

namespace {

std::uint32_t state_at(std::span<const std::uint8_t> map, std::uint64_t k, std::uint32_t b) {
  return map[k * b / 8] >> (k * b % 8) & ((1u << b) - 1);
}

}  // namespace

SdslTree::SdslTree(Level n, Format b, std::span<const std::uint8_t> map)
    : parts_(std::make_unique<Sequences>()) {
  const auto width = static_cast<std::uint32_t>(b);
  // The nodes by depth: their state, or 4 if the states below differ.
  std::vector<std::vector<std::uint8_t>> by_depth(n + 1);
  by_depth[n].resize(std::size_t{1} << (2 * n));
  for (std::size_t k = 0; k < by_depth[n].size(); ++k)
    by_depth[n][k] = static_cast<std::uint8_t>(state_at(map, k, width));
  for (Level d = n; d-- > 0;) {
    const auto& below = by_depth[d + 1];
    by_depth[d].resize(below.size() / 4);
    for (std::size_t k = 0; k < by_depth[d].size(); ++k) {
      const std::uint8_t* c = below.data() + 4 * k;
      by_depth[d][k] = c[0] == c[1] && c[1] == c[2] && c[2] == c[3] ? c[0] : std::uint8_t{4};
    }
  }
  std::vector<bool> nodes;
  std::vector<std::uint8_t> leaves;
  std::vector<std::uint64_t> at{0}, next;
  for (Level d = 0; d <= n; ++d, at.swap(next)) {
    next.clear();
    for (const std::uint64_t k : at) {
      const std::uint8_t state = by_depth[d][k];
      if (d < n) nodes.push_back(state == 4);
      if (state == 4)
        for (std::uint64_t c = 0; c < 4; ++c) next.push_back(4 * k + c);
      else
        leaves.push_back(state);
      parts_->internal += state == 4;
    }
  }
  parts_->n = n;
  parts_->nodes = sdsl::bit_vector(nodes.size(), 0);
  for (std::size_t k = 0; k < nodes.size(); ++k) parts_->nodes[k] = nodes[k];
  parts_->leaves = sdsl::int_vector<>(leaves.size(), 0, static_cast<std::uint8_t>(width));
  for (std::size_t k = 0; k < leaves.size(); ++k) parts_->leaves[k] = leaves[k];
  // The rank support refers to the vector in its final place.
  parts_->rank = sdsl::rank_support_v5<1>(&parts_->nodes);
}

SdslTree::~SdslTree() = default;
SdslTree::SdslTree(SdslTree&&) noexcept = default;
SdslTree& SdslTree::operator=(SdslTree&&) noexcept = default;

std::uint8_t SdslTree::operator[](std::uint32_t index) const { return parts_->find(index); }

void SdslTree::lookup(std::span<const SdslTree> trees, std::span<const std::uint32_t> which,
                      std::span<const std::uint32_t> index, std::span<std::uint8_t> state) {
  for (std::size_t k = 0; k < state.size(); ++k) state[k] = trees[which[k]].parts_->find(index[k]);
}

std::uint8_t SdslTree::chain(std::span<const SdslTree> trees, std::span<const std::uint32_t> which,
                             std::span<const std::uint32_t> index) {
  std::uint8_t state = 0;
  for (std::size_t k = 0; k < index.size(); ++k) state = trees[which[k]].parts_->find(index[k] ^ state);
  return state;
}

std::uint64_t SdslTree::bits() const {
  return 8 * (sdsl::size_in_bytes(parts_->nodes) + sdsl::size_in_bytes(parts_->rank) +
              sdsl::size_in_bytes(parts_->leaves));
}

std::size_t SdslTree::lines(std::uint32_t index) const {
  std::set<std::pair<int, std::uint64_t>> lines;
  std::uint64_t p = 0;
  const std::uint64_t width = parts_->leaves.width();
  for (std::uint32_t shift = 2 * parts_->n; shift > 0;) {
    // rank_support_v5 keeps two words for 2048 bits, and counts within at most six words of the vector.
    lines.insert({0, p / 2048 * 16 / 64});
    for (std::uint64_t word = p / 2048 * 32 + p % 2048 / 384 * 6; word <= p / 64; ++word)
      lines.insert({1, word / 8});
    const std::uint64_t before = parts_->rank(p);
    if (!parts_->nodes[p]) {
      lines.insert({2, (p - before) * width / 512});
      return lines.size();
    }
    shift -= 2;
    p = 4 * before + 1 + (index >> shift & 3);
  }
  lines.insert({2, (p - parts_->internal) * width / 512});
  return lines.size();
}

}  // namespace mmverify::bench
