// Common parts of the laws on a scene's parts: the parts of a level, and the check of a part.
#pragma once

#include <fmt/format.h>

#include "proofs/engine/cases.hpp"
#include "proofs/engine/kinds.hpp"

namespace mmverify::proofs::scene {

/// The domain of a law, all parts of a level: `count` is their number, `what` names them, `check` judges one.
struct Domain {
  std::string what;
  std::function<std::uint64_t(Level)> count;
  std::function<Finding(Level, std::uint64_t)> check;
};

inline Law on_cases(Law law, Domain parts) {
  law.how = "exhaustive";
  law.domain = [parts](Level n) {
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
