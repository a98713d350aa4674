#include "proofs/certificate/checker.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>
#include <unordered_map>
#include <vector>

namespace mmverify::proofs::certificate {
namespace {

using Clause = std::vector<int>;

/// A variable beyond this is a broken file.
constexpr long most_variables = 1L << 28;

/// Clauses with unit propagation by two watched literals.
class Clauses {
 public:
  /// Makes room for the variable.
  void define(int v) {
    const std::size_t needed = 2 * (static_cast<std::size_t>(v) + 1);
    if (watches_.size() < needed) watches_.resize(needed), value_.resize(needed, 0);
    defined_.resize(std::max(defined_.size(), static_cast<std::size_t>(v) + 1), false);
    defined_[static_cast<std::size_t>(v)] = true;
  }
  bool is_defined(int l) const {
    const auto v = static_cast<std::size_t>(std::abs(l));
    return v < defined_.size() && defined_[v];
  }

  void add(Clause c) {
    std::sort(c.begin(), c.end());
    c.erase(std::unique(c.begin(), c.end()), c.end());
    for (const int l : c)
      if (std::binary_search(c.begin(), c.end(), -l)) return;
    const std::uint64_t hash = hash_of(c);
    // Two literals that are not false are watched.
    std::stable_partition(c.begin(), c.end(), [this](int l) { return value(l) >= 0; });
    if (c.empty() || value(c[0]) < 0) {
      contradiction_ = true;
      return;
    }
    const bool unit = c.size() == 1 || value(c[1]) < 0;
    const int first = c[0];
    const auto number = static_cast<std::uint32_t>(clauses_.size());
    if (c.size() > 1) {
      watches_[at(c[0])].push_back(number);
      watches_[at(c[1])].push_back(number);
    }
    by_hash_.emplace(hash, number);
    clauses_.push_back(std::move(c));
    if (unit && value(first) == 0) {
      set(first);
      contradiction_ = !propagate();
      fixed_ = trail_.size();
      done_ = fixed_;
    }
  }

  /// A clause that makes a literal true for good stays.
  void remove(Clause c) {
    std::sort(c.begin(), c.end());
    c.erase(std::unique(c.begin(), c.end()), c.end());
    auto [from, to] = by_hash_.equal_range(hash_of(c));
    for (; from != to; ++from) {
      Clause same = clauses_[from->second];
      std::sort(same.begin(), same.end());
      if (same != c) continue;
      if (std::any_of(c.begin(), c.end(), [this](int l) { return value(l) > 0; })) return;
      // Watches of an empty clause are dropped when they are next met.
      clauses_[from->second] = {};
      by_hash_.erase(from);
      return;
    }
  }

  /// Whether the clause follows by unit propagation.
  bool follows(const Clause& c) {
    if (contradiction_) return true;
    bool contradicts = false;
    for (const int l : c) {
      if (value(l) > 0) contradicts = true;
      if (value(l) == 0) set(-l);
    }
    contradicts = contradicts || !propagate();
    while (trail_.size() > fixed_) {
      value_[at(trail_.back())] = value_[at(-trail_.back())] = 0;
      trail_.pop_back();
    }
    done_ = fixed_;
    return contradicts;
  }

 private:
  static std::size_t at(int l) { return 2 * static_cast<std::size_t>(std::abs(l)) + (l < 0 ? 1 : 0); }
  int value(int l) const { return value_[at(l)]; }
  void set(int l) {
    value_[at(l)] = 1;
    value_[at(-l)] = -1;
    trail_.push_back(l);
  }
  static std::uint64_t hash_of(const Clause& sorted) {
    std::uint64_t hash = sorted.size();
    for (const int l : sorted) hash = (hash ^ static_cast<std::uint32_t>(l)) * 0x100000001b3;
    return hash;
  }

  /// False if a clause has no literal left.
  bool propagate() {
    while (done_ < trail_.size())
      if (!look_at_watches(-trail_[done_++])) return false;
    return true;
  }

  bool look_at_watches(int falsified) {
    std::vector<std::uint32_t>& list = watches_[at(falsified)];
    std::size_t kept = 0;
    for (std::size_t k = 0; k < list.size(); ++k) {
      const std::uint32_t number = list[k];
      Clause& c = clauses_[number];
      if (c.empty()) continue;
      if (c[0] == falsified) std::swap(c[0], c[1]);
      if (value(c[0]) <= 0) {
        const auto other = std::find_if(c.begin() + 2, c.end(), [this](int l) { return value(l) >= 0; });
        if (other != c.end()) {
          std::swap(*other, c[1]);
          watches_[at(c[1])].push_back(number);
          continue;
        }
      }
      list[kept++] = number;
      if (value(c[0]) > 0) continue;
      if (value(c[0]) < 0) {
        for (++k; k < list.size(); ++k) list[kept++] = list[k];
        list.resize(kept);
        return false;
      }
      set(c[0]);
    }
    list.resize(kept);
    return true;
  }

  std::vector<Clause> clauses_;
  std::vector<std::vector<std::uint32_t>> watches_;  ///< by literal
  std::vector<signed char> value_;                   ///< by literal: 1 true, -1 false, 0 neither
  std::vector<bool> defined_;
  std::vector<int> trail_;
  std::size_t fixed_ = 0, done_ = 0;
  std::unordered_multimap<std::uint64_t, std::uint32_t> by_hash_;
  bool contradiction_ = false;
};

class Reader {
 public:
  Proved read(std::istream& in, const std::function<void()>& each_line) {
    std::string line;
    while (std::getline(in, line)) {
      ++number_;
      if (each_line) each_line();
      if (!line.empty()) step(line);
    }
    if (in.bad()) refuse("it cannot be read further");
    return proved_;
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw NotValid("line " + std::to_string(number_) + ": " + why);
  }

  void step(const std::string& line) {
    const bool plain = line[0] == '-' || (line[0] >= '0' && line[0] <= '9');
    const char kind = plain ? 'l' : line[0];
    const Clause c = numbers(plain ? line : line.substr(1));
    switch (kind) {
      case 'i': return define(c, 1, proved_.inputs);
      case 'f': define(c, 1, proved_.nodes); return clauses_.add({-c[0]});
      case 'n': return define_node(c);
      case 'd': return clauses_.remove(c);
      case 'a':
        expect(c, 1);
        ++proved_.assumptions;
        return clauses_.add(c);
      case 'l':
      case 'm':
        follow(c);
        ++proved_.steps;
        return clauses_.add(c);
      case 'o':
        expect(c, 2);
        follow(c);
        ++proved_.claims;
        return;
      default: refuse("no step begins with '" + line.substr(0, 1) + "'");
    }
  }

  Clause numbers(const std::string& text) const {
    std::istringstream in(text);
    Clause c;
    long n = 0;
    while (in >> n && n != 0) {
      if (std::abs(n) > most_variables) refuse("a variable beyond " + std::to_string(most_variables));
      c.push_back(static_cast<int>(n));
    }
    std::string behind;
    if (!in || n != 0 || in >> behind) refuse("a step is numbers with a 0 at the end");
    return c;
  }

  void expect(const Clause& c, std::size_t count) const {
    if (c.size() != count)
      refuse("the step has " + std::to_string(c.size()) + " numbers, not " + std::to_string(count));
    for (const int l : c)
      if (!clauses_.is_defined(l)) refuse("variable " + std::to_string(std::abs(l)) + " has no line before");
  }

  void define(const Clause& c, std::size_t count, std::uint64_t& counter) {
    if (c.size() != count || c[0] <= 0) refuse("it names no variable");
    if (clauses_.is_defined(c[0])) refuse("variable " + std::to_string(c[0]) + " has a second line");
    clauses_.define(c[0]);
    ++counter;
  }

  void define_node(const Clause& c) {
    if (c.size() != 3) refuse("a node has a variable and two literals");
    expect({c[1], c[2]}, 2);
    define(c, 3, proved_.nodes);
    clauses_.add({-c[0], c[1]});
    clauses_.add({-c[0], c[2]});
    clauses_.add({c[0], -c[1], -c[2]});
  }

  void follow(const Clause& c) {
    for (const int l : c)
      if (!clauses_.is_defined(l)) refuse("variable " + std::to_string(std::abs(l)) + " has no line before");
    if (!clauses_.follows(c)) refuse("the clause does not follow by unit propagation");
  }

  std::uint64_t number_ = 0;
  Clauses clauses_;
  Proved proved_;
};

}  // namespace

Proved check(std::istream& certificate, const std::function<void()>& each_line) {
  return Reader().read(certificate, each_line);
}

}  // namespace mmverify::proofs::certificate
