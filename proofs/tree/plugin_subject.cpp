#include "proofs/tree/plugin_subject.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "dock/codec.hpp"
#include "sdk/mmverify_subject.h"

namespace mmverify::proofs::tree {
namespace {

using dock::Call;
using dock::Library;
using dock::LibraryPtr;
using spec::micromap::micro_triangles;

constexpr std::uint8_t no_state = 0xFF;

std::size_t map_bytes(Level n, Format f) {
  return static_cast<std::size_t>(spec::micromap::packed_bytes(micro_triangles(n), f));
}

dock::Answer ask_decoder(const Library& library, Level n, Format f, std::span<const std::uint8_t> code) {
  return dock::ask(library, {Call::tree_decode, n, bits(f), code, map_bytes(n, f)},
                   [&] { return "decoding " + dock::code_text(bits(f), code); });
}

class PluginCode : public Code {
 public:
  PluginCode(LibraryPtr library, Level n, Format f, Bytes code)
      : library_(std::move(library)), n_(n), format_(f), code_(std::move(code)) {}

  Bytes decode() const override {
    if (library_->offers(Call::tree_decode)) {
      dock::Answer answer = ask_decoder(*library_, n_, format_, code_);
      return answer.taken ? std::move(answer.bytes) : Bytes{};
    }
    if (library_->offers(Call::tree_lookup)) {
      std::vector<std::uint32_t> all(micro_triangles(n_));
      std::iota(all.begin(), all.end(), 0u);
      return looked_up([&](Bytes& states) { lookup(all, states); });
    }
    if (library_->offers(Call::tree_lookup_f32))
      return looked_up([&](Bytes& states) { look_inside(states); });
    return specified();
  }

  void lookup(std::span<const std::uint32_t> index, std::span<std::uint8_t> state) const override {
    ask(Call::tree_lookup, {index.data()}, state,
        [&](std::uint64_t k) { return fmt::format("k={}", index[k]); });
  }
  void lookup(std::span<const float> u, std::span<const float> v,
              std::span<std::uint8_t> state) const override {
    ask(Call::tree_lookup_f32, {u.data(), v.data()}, state,
        [&](std::uint64_t k) { return fmt::format("u={:a},v={:a}", u[k], v[k]); });
  }
  Bytes bytes() const override { return code_; }

 private:
  void ask(Call call, std::vector<const void*> arrays, std::span<std::uint8_t> state,
           std::function<std::string(std::uint64_t)> element) const {
    dock::look_up(*library_, {call, n_, bits(format_), code_, std::move(arrays), std::move(element)}, state);
  }

  /// The map of the states found; none where one is no state of the format.
  template <class Find>
  Bytes looked_up(Find find) const {
    Bytes states(micro_triangles(n_), no_state);
    find(states);
    States map;
    for (const std::uint8_t s : states) {
      if (s >> bits(format_) != 0) return {};
      map.push_back(static_cast<State>(s));
    }
    return spec::micromap::pack(map, format_);
  }

  /// The states at a point inside each micro-triangle: half of one corner and a quarter of either other.
  void look_inside(Bytes& states) const {
    std::vector<float> u, v;
    const float quarter = 0.25f / static_cast<float>(spec::side(n_));
    for (std::uint64_t k = 0; k < states.size(); ++k) {
      const auto c = spec::index::corners(static_cast<std::uint32_t>(k), n_);
      u.push_back(static_cast<float>(2 * c[0].i + c[1].i + c[2].i) * quarter);
      v.push_back(static_cast<float>(2 * c[0].j + c[1].j + c[2].j) * quarter);
    }
    lookup(u, v, states);
  }

  Bytes specified() const {
    const auto tree = spec::tree::from_bytes(code_, format_);
    const auto map = tree ? spec::tree::decode(*tree, n_, format_) : std::nullopt;
    return map ? spec::micromap::pack(*map, format_) : Bytes{};
  }

  LibraryPtr library_;
  Level n_;
  Format format_;
  Bytes code_;
};

/// A code that was read: its map is known.
class ReadCode : public PluginCode {
 public:
  ReadCode(LibraryPtr library, Level n, Format f, Bytes code, Bytes map)
      : PluginCode(std::move(library), n, f, std::move(code)), map_(std::move(map)) {}
  Bytes decode() const override { return map_; }

 private:
  Bytes map_;
};

/// What an encoder that gave up left.
class NoCode : public Code {
 public:
  Bytes decode() const override { return {}; }
  void lookup(std::span<const std::uint32_t>, std::span<std::uint8_t> state) const override {
    std::fill(state.begin(), state.end(), no_state);
  }
  void lookup(std::span<const float>, std::span<const float>, std::span<std::uint8_t> state) const override {
    std::fill(state.begin(), state.end(), no_state);
  }
  Bytes bytes() const override { return {}; }
};

class PluginTree : public TreeSubject {
 public:
  PluginTree(std::string name, LibraryPtr library)
      : TreeSubject(std::move(name), library->about()), library_(std::move(library)) {}

  std::string fingerprint() const override { return library_->fingerprint(); }
  /// Its floats stand for themselves.
  Level max_level() const override {
    return std::min<Level>(TreeSubject::max_level(), library_->description().max_level);
  }

  /// What the specification does in the subject's place is not judged as the subject's.
  bool has(Entry e) const override {
    switch (e) {
      case Entry::lookup:
        return library_->offers(Call::tree_lookup);
      case Entry::point:
        return library_->offers(Call::tree_lookup_f32);
      case Entry::bytes:
        return library_->offers(Call::tree_decode);
      case Entry::stream:
        return library_->offers(Call::tree_encode) &&
               (library_->description().flags & MMVERIFY_TREE_STREAM) != 0;
      case Entry::paper:
        return library_->offers(Call::tree_decode) &&
               (library_->description().flags & MMVERIFY_TREE_STREAM) != 0;
      case Entry::reads:
        return false;
    }
    return false;
  }

  CodePtr encode(const Map& map) const override {
    const Level n = map.level;
    const Format f = map.format;
    if (!library_->offers(Call::tree_encode)) {
      const States states = spec::micromap::unpack(map.packed, f, micro_triangles(n));
      return std::make_unique<PluginCode>(library_, n, f,
                                          spec::tree::bytes(spec::tree::encode(states, n), f));
    }
    // Room for a code some times larger than the map, so that most maps are asked about once.
    dock::Answer answer =
        dock::ask(*library_, {Call::tree_encode, n, bits(f), map.packed, 64 + 2 * map.packed.size()},
                  [&] { return "encoding " + dock::map_text(bits(f), micro_triangles(n), map.packed); });
    if (!answer.taken) return std::make_unique<NoCode>();
    return std::make_unique<PluginCode>(library_, n, f, std::move(answer.bytes));
  }

  CodePtr open(Level n, Format f, std::span<const std::uint8_t> bytes) const override {
    dock::Answer answer = ask_decoder(*library_, n, f, bytes);
    if (!answer.taken) return nullptr;
    return std::make_unique<ReadCode>(library_, n, f, Bytes(bytes.begin(), bytes.end()),
                                      std::move(answer.bytes));
  }

 private:
  LibraryPtr library_;
};

}  // namespace

TreeSubjectPtr plugin_subject(const std::string& name, const LibraryPtr& library) {
  if (!library->offers(dock::Topic::tree)) return nullptr;
  const bool encodes = library->offers(Call::tree_encode), decodes = library->offers(Call::tree_decode),
             looks_up = library->offers(Call::tree_lookup) || library->offers(Call::tree_lookup_f32),
             stream = (library->description().flags & MMVERIFY_TREE_STREAM) != 0;
  if (!stream && !encodes)
    throw dock::CannotLoad(fmt::format(
        "{}: it decodes trees and has no tree_encode; set the flag MMVERIFY_TREE_STREAM if its codes "
        "are the paper's",
        library->path()));
  if (!stream && !decodes && !looks_up)
    throw dock::CannotLoad(
        fmt::format("{}: nothing leads from the codes of tree_encode back to the map; add tree_decode or "
                    "tree_lookup, or set the flag MMVERIFY_TREE_STREAM if they are the paper's",
                    library->path()));
  return std::make_shared<PluginTree>(name, library);
}

}  // namespace mmverify::proofs::tree
