// What the laws on a scene's parts are put together from: so many parts a level, and how one is judged.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>

#include "proofs/engine/cases.hpp"
#include "proofs/engine/kinds.hpp"

namespace mmverify::proofs::scene {

/// A law on all parts of a level: `parts` says how many, `what` names them, `check` judges one.
struct Domain {
  std::string what;
  std::function<std::uint64_t(Level)> count;
  std::function<Finding(Level, std::uint64_t)> check;
};

inline Law on_cases(Law law, Domain parts) {
  law.method = Method::exhaustive;
  law.how = [](const Subject&, Level) { return std::string("exhaustive"); };
  law.domain = [parts](const Subject&, Level n) {
    return fmt::format("the {} {} of level {} of this scene", parts.count(n), parts.what, n);
  };
  law.unfit = [parts](const Subject&, Level n) -> std::optional<std::string> {
    if (parts.count(n) != 0) return std::nullopt;
    return fmt::format("no {}", parts.what);
  };
  const auto check_text = [parts](const Subject&, Level n, const std::string& at) {
    std::uint64_t k = 0;
    if (std::sscanf(at.c_str(), "%lu", &k) != 1 || fmt::format("{}", k) != at || k >= parts.count(n))
      throw BadCase(fmt::format("{}: not one of the {} {}", at, parts.count(n), parts.what));
    return parts.check(n, k);
  };
  return on_numbered_cases(
      std::move(law),
      {[parts](Level n, const Run&) { return parts.count(n); },
       [parts](const Subject&, Level n, std::uint64_t k, const Run&) { return parts.check(n, k); },
       [](const Subject&, Level, std::uint64_t k, const Run&) { return fmt::format("{}", k); }, check_text, 1,
       Kind::interior});
}

}  // namespace mmverify::proofs::scene
