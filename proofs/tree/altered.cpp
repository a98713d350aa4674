#include "proofs/tree/altered.hpp"

namespace mmverify::proofs::tree {
namespace {

class AlteredCode : public Code {
 public:
  AlteredCode(CodePtr base, Map map, const Change& change)
      : base_(std::move(base)), map_(std::move(map)), change_(change) {}
  Bytes decode() const override {
    Bytes map = base_->decode();
    if (change_.decode) change_.decode(map_, map);
    return map;
  }
  void lookup(std::span<const std::uint32_t> index, std::span<std::uint8_t> state) const override {
    base_->lookup(index, state);
    if (change_.lookup)
      for (std::size_t k = 0; k < index.size(); ++k) change_.lookup(map_, index[k], state[k]);
    if (change_.batch) change_.batch(map_, state);
  }
  void lookup(std::span<const float> u, std::span<const float> v,
              std::span<std::uint8_t> state) const override {
    base_->lookup(u, v, state);
    if (change_.point)
      for (std::size_t k = 0; k < u.size(); ++k) change_.point(map_, u[k], v[k], state[k]);
  }
  Bytes bytes() const override {
    Bytes bytes = base_->bytes();
    if (change_.bytes) change_.bytes(map_, bytes);
    return bytes;
  }
  std::uint64_t tree_bits_read(std::uint64_t index) const override {
    const std::uint64_t bits = base_->tree_bits_read(index);
    return change_.reads ? change_.reads(map_.level, index, bits) : bits;
  }

 private:
  CodePtr base_;
  Map map_;
  const Change& change_;  // of the subject, which outlives its codes
};

class Altered : public TreeSubject {
 public:
  Altered(const std::string& name, TreeSubjectPtr base, Change change)
      : TreeSubject(name, "broken on purpose"), base_(std::move(base)), change_(std::move(change)) {}
  bool has(Entry e) const override { return base_->has(e); }
  Level max_level() const override { return base_->max_level(); }
  CodePtr encode(const Map& map) const override {
    Map changed = map;
    if (change_.encode) change_.encode(changed);
    return std::make_unique<AlteredCode>(base_->encode(changed), map, change_);
  }
  CodePtr open(Level n, Format f, std::span<const std::uint8_t> bytes) const override {
    CodePtr code = base_->open(n, f, bytes);
    return change_.open ? change_.open(n, f, bytes, std::move(code)) : std::move(code);
  }

 private:
  TreeSubjectPtr base_;
  Change change_;
};

}  // namespace

TreeSubjectPtr altered(const std::string& name, const std::string& base, Change change) {
  return std::make_shared<Altered>(name, built_in(base), std::move(change));
}

Mutant mutant(const char* name, const char* base, Levels levels, Change change) {
  return {name, altered(name, base, std::move(change)), levels};
}

}  // namespace mmverify::proofs::tree
