#include "proofs/bake/law_parts.hpp"

namespace mmverify::proofs::bake {
namespace {

constexpr Level highest_level = 12;

const BakeSubject& of_bake(const Subject& s) { return dynamic_cast<const BakeSubject&>(s); }

}  // namespace

Law over(Law law, const Cases& cases, const Check& check, const Draw& draw,
         const std::function<std::optional<std::string>(const BakeSubject&)>& lacks) {
  law.topic = "bake";
  law.divisible = true;
  law.on_lines = false;
  if (law.long_run == Levels{}) law.long_run = law.fast;
  if (!law.how)
    law.how = [method = law.method](const Subject&, Level) { return std::string(to_string(method)); };
  law.unfit = [lacks](const Subject& s, Level n) -> std::optional<std::string> {
    const auto* subject = dynamic_cast<const BakeSubject*>(&s);
    if (subject == nullptr) return "not a subject of topic bake";
    if (n > highest_level) return fmt::format("bakers go up to level {}", highest_level);
    return lacks ? lacks(*subject) : std::nullopt;
  };
  law.cases = cases.count;
  law.judge = [cases, check](const Subject& s, Level n, const Run& run) {
    return sweep(run, cases.count(n, run), cases.chunk, [&](Chunk chunk, Tally& tally) {
      for (std::uint64_t k = chunk.begin; k < chunk.end; ++k) {
        const Case one = cases.number(n, k, run.seed);
        const Finding found = check(of_bake(s), one, n, k);
        if (found.declined)
          tally.decline(Kind::interior);
        else
          tally.count(Kind::interior, 1);
        tally.digest(k, found.answer);
        if (!found.holds)
          tally.mismatch(Kind::interior, {n, k, 0}, [&] {
            const Said said = found.said();
            return Counterexample{{n, k, 0}, n, text_of(one), {}, said.expected, said.got};
          });
      }
    });
  };
  law.replay = [check, draw](const Subject& s, Level n, const std::string& at) {
    const Case one = case_from(at);
    const Finding found = check(of_bake(s), one, n, std::nullopt);
    if (found.declined) throw BadCase("'" + at.substr(0, 60) + "': the subject does not support it");
    const std::string picture = draw ? draw(of_bake(s), one, n) : std::string();
    const Said said = found.holds ? Said{"ok", "ok"} : found.said();
    return Replayed{found.holds, said.expected, said.got, picture};
  };
  return law;
}

}  // namespace mmverify::proofs::bake
