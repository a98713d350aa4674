#include "proofs/engine/shards.hpp"

#include <fmt/format.h>

namespace mmverify::proofs {
namespace {

std::string text(const Shard& s) { return fmt::format("shard {}/{}", s.number, s.of); }

std::string text(const Result& r) { return fmt::format("{} {} level {}", r.law, r.subject, r.level); }

bool same_job(const Result& a, const Result& b) { return a.law == b.law && a.subject == b.subject; }

/// One of each number, all of one run.
void check_numbers(std::vector<ShardRun>& shards) {
  std::stable_sort(shards.begin(), shards.end(),
                   [](const ShardRun& a, const ShardRun& b) { return a.shard.number < b.shard.number; });
  const ShardRun& first = shards.front();
  for (const ShardRun& s : shards) {
    if (!s.finished) throw ShardsDoNotAddUp(fmt::format("{}: {} was interrupted", s.file, text(s.shard)));
    if (s.shard.of != first.shard.of)
      throw ShardsDoNotAddUp(
          fmt::format("{} is {}, {} is {}", first.file, text(first.shard), s.file, text(s.shard)));
    if (const std::string what = difference(s.identity, first.identity); !what.empty())
      throw ShardsDoNotAddUp(fmt::format("{}: not of the run of {} ({})", s.file, first.file, what));
  }
  for (std::size_t k = 0; k < std::max<std::size_t>(shards.size(), first.shard.of); ++k) {
    const std::uint32_t number = static_cast<std::uint32_t>(k) + 1;
    if (k > 0 && k < shards.size() && shards[k].shard.number == shards[k - 1].shard.number)
      throw ShardsDoNotAddUp(
          fmt::format("{} and {}: both are {}", shards[k - 1].file, shards[k].file, text(shards[k].shard)));
    if (k >= shards.size() || shards[k].shard.number != number)
      throw ShardsDoNotAddUp(fmt::format("shard {}/{} is missing", number, first.shard.of));
  }
}

/// The shards' results for the job and level of `like`, and whether a shard's subject broke before it came so
/// far.
struct Parts {
  std::vector<std::pair<const ShardRun*, const Result*>> found;
  bool broke_before = false;
};

Parts parts_of(const std::vector<ShardRun>& shards, const Result& like) {
  Parts parts;
  for (const ShardRun& s : shards) {
    const auto& results = s.report.results;
    const auto at = std::find_if(results.begin(), results.end(),
                                 [&](const Result& r) { return same_job(r, like) && r.level == like.level; });
    const bool broke = std::any_of(results.begin(), results.end(), [&](const Result& r) {
      return same_job(r, like) && r.verdict == Verdict::broken;
    });
    if (at != results.end())
      parts.found.emplace_back(&s, &*at);
    else if (broke)
      parts.broke_before = true;
    else
      throw ShardsDoNotAddUp(fmt::format("{}: {} is missing", s.file, text(like)));
  }
  return parts;
}

/// The shares, side by side, are the domain.
void check_cover(std::vector<std::pair<const ShardRun*, const Result*>> parts, const Result& like) {
  for (const auto& [shard, r] : parts) {
    if (!r->share)
      throw ShardsDoNotAddUp(fmt::format("{}: {}: no share of it is named", shard->file, text(like)));
    if (r->verdict == Verdict::incomplete)
      throw ShardsDoNotAddUp(fmt::format("{}: {} is incomplete", shard->file, text(like)));
    if (r->share->of != parts.front().second->share->of || r->cases_expected != like.cases_expected)
      throw ShardsDoNotAddUp(fmt::format("{}: {}: a share of another domain", shard->file, text(like)));
  }
  std::stable_sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
    return std::pair(a.second->share->from, a.second->share->to) <
           std::pair(b.second->share->from, b.second->share->to);
  });
  std::uint64_t done = 0;
  for (const auto& [shard, r] : parts) {
    if (r->share->from == r->share->to) continue;
    if (r->share->from != done)
      throw ShardsDoNotAddUp(fmt::format("{}: {}: units {} to {} are {}", shard->file, text(like),
                                         std::min(done, r->share->from), std::max(done, r->share->from),
                                         r->share->from < done ? "covered twice" : "left out"));
    done = r->share->to;
  }
  if (done != parts.front().second->share->of)
    throw ShardsDoNotAddUp(
        fmt::format("{}: units {} to {} are left out", text(like), done, parts.front().second->share->of));
}

Result merged(const Parts& parts, const Result& like, std::size_t errors, const Law& law) {
  Result sum = like;
  sum.share.reset();
  name_proof(sum, law);
  sum.seconds = 0;
  for (const auto& [shard, r] : parts.found) {
    sum.seconds += r->seconds;
    if (r->verdict != Verdict::not_applicable) {
      sum.method = r->method;
      sum.domain = r->domain;
    }
  }
  const auto broken = std::find_if(parts.found.begin(), parts.found.end(),
                                   [](const auto& part) { return part.second->verdict == Verdict::broken; });
  if (broken != parts.found.end()) {
    sum.verdict = Verdict::broken;
    sum.reason = broken->second->reason;
    return sum;
  }
  const bool fits = std::any_of(parts.found.begin(), parts.found.end(),
                                [](const auto& part) { return part.second->share.has_value(); });
  if (!fits) return sum;
  check_cover(parts.found, like);
  Tally tally(errors);
  for (const auto& [shard, r] : parts.found)
    tally.merge(Tally::restored(r->by_kind, r->digest, r->counterexamples));
  sum.by_kind = tally.by_kind();
  sum.digest = tally.digest();
  sum.counterexamples = tally.found();
  sum.reason.clear();
  sum.resumed = 0;
  if (sum.cases_run() != sum.cases_expected)
    throw ShardsDoNotAddUp(
        fmt::format("{}: {} cases in all, {} expected", text(like), sum.cases_run(), sum.cases_expected));
  settle(sum, law.method == Method::sample);
  return sum;
}

}  // namespace

Report merge_shards(std::vector<ShardRun> shards, std::size_t errors,
                    const std::function<const Law&(const std::string&)>& law_of) {
  check_numbers(shards);
  std::vector<const Result*> jobs;
  for (const ShardRun& s : shards)
    for (const Result& r : s.report.results)
      if (std::none_of(jobs.begin(), jobs.end(),
                       [&](const Result* other) { return same_job(*other, r) && other->level == r.level; }))
        jobs.push_back(&r);
  Report whole;
  whole.threads = 0;
  for (const Result* job : jobs) {
    const Parts parts = parts_of(shards, *job);
    // The whole run would not have come so far.
    if (!parts.broke_before) whole.results.push_back(merged(parts, *job, errors, law_of(job->law)));
  }
  for (const ShardRun& s : shards) {
    whole.threads += s.report.threads;
    whole.mutants.insert(whole.mutants.end(), s.report.mutants.begin(), s.report.mutants.end());
    for (const Diagnosis& d : s.report.diagnoses)
      if (std::none_of(whole.diagnoses.begin(), whole.diagnoses.end(),
                       [&](const Diagnosis& other) { return other.lines == d.lines && other.law == d.law; }))
        whole.diagnoses.push_back(d);
  }
  return whole;
}

}  // namespace mmverify::proofs
