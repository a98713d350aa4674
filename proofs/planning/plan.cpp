#include "proofs/planning/plan.hpp"

#include <fmt/format.h>

#include "proofs/registry/registry.hpp"

namespace mmverify::proofs {
namespace {

bool about(const Law& law, const Subject& subject) {
  return law.general ||
         std::find(law.subjects.begin(), law.subjects.end(), subject.name()) != law.subjects.end();
}

bool planned(const std::vector<Job>& jobs, const Law& law, const Subject& subject) {
  return std::any_of(jobs.begin(), jobs.end(), [&](const Job& job) {
    return job.law == &law && job.subject->name() == subject.name();
  });
}

bool fits_somewhere(const Law& law, const Subject& subject, const Levels& levels) {
  if (!subject.absent().empty()) return false;
  for (Level n = levels.first; n <= levels.last; ++n)
    if (!law.unfit(subject, n)) return true;
  return false;
}

/// The companion of a law on a float subject, if it is about that subject: one takes binary64 numbers, another has no
/// entry point for points.
const Law* companion(const Law& law, const Subject& subject) {
  const Law* on_floats = law.companion.empty() ? nullptr : find_law(law.companion);
  return on_floats != nullptr && fits_somewhere(*on_floats, subject, on_floats->tiers.long_run) ? on_floats
                                                                                                : nullptr;
}

/// The law that replaces this one in a dialect, if it is about the subject.  It does not replace the law for the
/// law's own subjects, which promise its statement.
const Law& in_dialect(const Law& law, const Subject& subject, const std::string& dialect) {
  if (std::find(law.subjects.begin(), law.subjects.end(), subject.name()) != law.subjects.end()) return law;
  for (const auto& [name, id] : law.in_dialect)
    if (const Law* other = find_law(id);
        name == dialect && fits_somewhere(*other, subject, other->tiers.long_run))
      return *other;
  return law;
}

/// Orders of attribute micromaps.  The library takes elements in batches, some ns each, and goes on to level 12; the
/// specification's walks do not, and are proved at every level by induction (proofs/attribute/induction).
constexpr std::array<std::string_view, 9> of_orders{
    "attribute.order_bijective",     "attribute.order_inverse",     "attribute.order_is_walk",
    "attribute.face_orders",         "attribute.convert",           "attribute.convert_faces",
    "attribute.order_prefix_nested", "attribute.triangle_vertices", "attribute.umajor_is_reversed_rows"};

}  // namespace

std::vector<Job> plan(const Request& request) {
  std::vector<const Law*> chosen = request.laws;
  if (chosen.empty())
    for (const Law& law : laws())
      if (!law.by_id_only && (!law.long_only || request.tier == Tier::long_run)) chosen.push_back(&law);

  std::vector<Job> jobs;
  const auto add = [&](const Law& law, const SubjectPtr& subject, const Law* brought_by) {
    if (planned(jobs, law, *subject)) return;
    Job job{&law,
            subject,
            request.tier == Tier::fast ? fast_levels(law, *subject) : law.tiers.long_run,
            {},
            brought_by};
    if (request.levels && law.at_once.empty()) job.levels = *request.levels;
    if (!subject->absent().empty())
      job.unfit = subject->absent();
    else if (subject->topic() != law.topic)
      job.unfit = fmt::format("{} is a subject of topic {}", subject->name(), subject->topic());
    else if (!about(law, *subject))
      job.unfit = fmt::format("{} is about {}", law.id, fmt::join(law.subjects, ", "));
    jobs.push_back(std::move(job));
  };
  for (const Law* law : chosen) {
    std::vector<SubjectPtr> on = request.subjects;
    if (on.empty())
      for (const std::string& name : law->subjects) on.push_back(find_subject(name));
    const bool of_its_topic =
        std::any_of(on.begin(), on.end(), [&](const SubjectPtr& s) { return s->topic() == law->topic; });
    for (const SubjectPtr& subject : on) {
      // A run of every law on one subject leaves out laws about other subjects; a library may have subjects of
      // several topics.
      const bool other_topic = subject->topic() != law->topic;
      if (request.laws.empty() ? !about(*law, *subject) || other_topic : other_topic && of_its_topic)
        continue;
      const bool named =
          std::find(request.by_id.begin(), request.by_id.end(), law->id) != request.by_id.end();
      if (law->alternative && !named && !request.subjects.empty()) continue;
      add(named ? *law : in_dialect(*law, *subject, request.dialect), subject, nullptr);
      // A law that does not apply proves nothing that floats could deny.
      const Levels run = request.levels.value_or(request.tier == Tier::fast ? fast_levels(*law, *subject)
                                                                            : law->tiers.long_run);
      if (request.companions && !subject->exact() && fits_somewhere(*law, *subject, run))
        for (const Law* on_floats = companion(*law, *subject); on_floats != nullptr;
             on_floats = companion(*on_floats, *subject))
          add(in_dialect(*on_floats, *subject, request.dialect), subject, named ? law : nullptr);
    }
  }
  return jobs;
}

Verdict weaker(Verdict a, Verdict b) {
  for (const Verdict v : {Verdict::broken, Verdict::refuted, Verdict::incomplete, Verdict::checked})
    if (a == v || b == v) return v;
  return a == Verdict::proved ? a : b;
}

Verdict weakest(const std::vector<Result>& results, const std::string& subject) {
  Verdict found = Verdict::not_applicable;
  for (const Result& r : results)
    if (r.subject == subject) found = weaker(found, r.verdict);
  return found;
}

std::vector<Level> levels_not_judged(const std::vector<Result>& results, const std::string& subject,
                                     const Levels& asked) {
  std::vector<const Result*> of_levels;
  for (const Result& r : results)
    if (r.at_once.empty() && (subject.empty() || r.subject == subject)) of_levels.push_back(&r);
  std::vector<Level> left;
  for (Level n = asked.first; n <= asked.last && !of_levels.empty(); ++n)
    if (std::none_of(of_levels.begin(), of_levels.end(), [n](const Result* r) {
          return r->level == n && (r->verdict != Verdict::not_applicable || r->share);
        }))
      left.push_back(n);
  return left;
}

std::vector<std::pair<std::string, Levels>> fast_levels_apart(const Law& law) {
  // It asks for each vertex on 16 levels, not on one or two.
  if (law.id == "attribute.bird_prefix") return {{"attribute", {0, 10}}};
  if (std::find(of_orders.begin(), of_orders.end(), law.id) == of_orders.end()) return {};
  return {{"attribute", {0, 12}}};
}

Levels fast_levels(const Law& law, const Subject& subject) {
  for (const auto& [name, levels] : fast_levels_apart(law))
    if (name == subject.name()) return levels;
  return law.tiers.fast;
}

}  // namespace mmverify::proofs
