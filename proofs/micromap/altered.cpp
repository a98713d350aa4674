#include "proofs/micromap/altered.hpp"

namespace mmverify::proofs::micromap {
namespace {

class Altered final : public MicromapSubject {
 public:
  Altered(std::string name, MicromapSubjectPtr base, Change change)
      : MicromapSubject(std::move(name), base->name() + ", altered"),
        base_(std::move(base)),
        change_(std::move(change)) {}
  bool has(Entry e) const override { return base_->has(e); }

  Bytes pack(Format f, const States& states) const override {
    Bytes out = base_->pack(f, states);
    if (change_.pack) change_.pack(f, states, out);
    return out;
  }
  States unpack(Format f, std::uint64_t count, std::span<const std::uint8_t> bytes) const override {
    States out = base_->unpack(f, count, bytes);
    if (change_.unpack) change_.unpack(f, out);
    return out;
  }
  Bytes force2(Level n, std::span<const std::uint8_t> in) const override {
    return changed(change_.force2, n, Format::four_state, in, base_->force2(n, in));
  }
  Bytes widen(Level n, std::span<const std::uint8_t> in) const override {
    return changed(change_.widen, n, Format::two_state, in, base_->widen(n, in));
  }
  Bytes up(Level n, Format f, std::span<const std::uint8_t> in) const override {
    return changed(change_.up, n, f, in, base_->up(n, f, in));
  }
  Bytes down(Level n, Format f, std::span<const std::uint8_t> in) const override {
    return changed(change_.down, n, f, in, base_->down(n, f, in));
  }
  Bytes through(Level n, Mode mode, std::span<const std::uint8_t> in) const override {
    Bytes out = base_->through(n, mode, in);
    if (change_.through) change_.through(n, mode, in, out);
    return out;
  }
  std::uint32_t special_code(State s, Encoding e) const override {
    std::uint32_t code = base_->special_code(s, e);
    if (change_.special_code) change_.special_code(s, e, code);
    return code;
  }
  Meaning meaning(std::uint32_t code, Encoding e) const override {
    Meaning m = base_->meaning(code, e);
    if (change_.meaning) change_.meaning(code, e, m);
    return m;
  }
  Bytes substitute(Level n, std::span<const std::uint8_t> in) const override {
    return changed(change_.substitute, n, Format::four_state, in, base_->substitute(n, in));
  }
  Kept judge(Level n, std::span<const std::uint8_t> was, std::span<const std::uint8_t> is) const override {
    Kept kept = base_->judge(n, was, is);
    if (change_.judge) change_.judge(n, was, is, kept);
    return kept;
  }
  Built build(std::span<const PackedMap> before, std::span<const PackedMap> maps,
              const Options& options) const override {
    Options taken = options;
    if (change_.build_input) change_.build_input(maps, taken);
    Built built = base_->build(before, maps, taken);
    if (change_.build) change_.build(maps, options, built);
    return built;
  }
  std::vector<Violation> validate(const Input& in) const override {
    std::vector<Violation> found = base_->validate(in);
    if (change_.validate) change_.validate(in, found);
    return found;
  }

 private:
  static Bytes changed(const Change::OnBytes& change, Level n, Format f, std::span<const std::uint8_t> in,
                       Bytes out) {
    if (change) change(n, f, in, out);
    return out;
  }

  MicromapSubjectPtr base_;
  Change change_;
};

}  // namespace

Mutant mutant(std::string name, const std::string& base, Levels levels, Change change) {
  auto subject = std::make_shared<Altered>(name, the(base), std::move(change));
  return {std::move(name), std::move(subject), levels};
}

}  // namespace mmverify::proofs::micromap
