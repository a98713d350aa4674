#include "proofs/engine/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

namespace mmverify::proofs {
namespace {

using Json = nlohmann::ordered_json;
using namespace std::chrono_literals;

constexpr char schema[] = "mmverify.journal/1";

std::string line_of(const std::string& json) {
  boost::crc_32_type crc;
  crc.process_bytes(json.data(), json.size());
  return fmt::format("{:08x} {}\n", crc.checksum(), json);
}

/// The line's JSON; nothing if the checksum does not match.
std::optional<Json> checked(const std::string& line) {
  if (line.size() < 10 || line_of(line.substr(9)) != line + "\n") return std::nullopt;
  Json json = Json::parse(line.substr(9), nullptr, false);
  return json.is_object() ? std::optional(std::move(json)) : std::nullopt;
}

/// Names and messages may be any bytes: invalid UTF-8 is written as U+FFFD.
std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json to_json(const Identity& identity) {
  Json items{{"schema", schema}};
  for (const auto& [name, value] : identity) items[name] = value;
  return items;
}

Identity identity_of(const Json& json) {
  Identity identity;
  for (const auto& [name, value] : json.items())
    if (name != "schema" && value.is_string()) identity.emplace_back(name, value.get<std::string>());
  return identity;
}

/// A name after a journal has written and read it.
std::string as_written(const std::string& name) { return Json::parse(text_of(name)).get<std::string>(); }
Identity as_written(Identity identity) {
  for (auto& [name, value] : identity) value = as_written(value);
  return identity;
}

Json to_json(const Counterexample& c) {
  return {
      {"simplicity", c.simplicity}, {"at", c.at}, {"hex", c.hex}, {"expected", c.expected}, {"got", c.got}};
}

Counterexample counterexample(const Json& j) {
  Counterexample c;
  j.at("simplicity").get_to(c.simplicity);
  j.at("at").get_to(c.at);
  j.at("hex").get_to(c.hex);
  j.at("expected").get_to(c.expected);
  j.at("got").get_to(c.got);
  return c;
}

Json to_json(const Journal::Piece& piece) {
  Json counts = Json::array(), found = Json::array();
  for (const Count& c : piece.tally.by_kind())
    counts.push_back({c.cases, c.mismatches, c.declined, c.allowed});
  for (const Counterexample& c : piece.tally.found()) found.push_back(to_json(c));
  Json json{{"about", piece.about},  {"from", piece.units.begin},
            {"to", piece.units.end}, {"of", piece.of},
            {"counts", counts},      {"digest", fmt::format("{:016x}", piece.tally.digest())}};
  if (!found.empty()) json["found"] = found;
  return json;
}

Journal::Piece piece(const Json& j) {
  CountByKind counts{};
  for (std::size_t k = 0; k < kinds; ++k) {
    j.at("counts").at(k).at(0).get_to(counts[k].cases);
    j.at("counts").at(k).at(1).get_to(counts[k].mismatches);
    j.at("counts").at(k).at(2).get_to(counts[k].declined);
    j.at("counts").at(k).at(3).get_to(counts[k].allowed);
  }
  std::vector<Counterexample> found;
  if (j.contains("found"))
    for (const Json& c : j.at("found")) found.push_back(counterexample(c));
  return {
      j.at("about").get<std::string>(),
      {j.at("from").get<std::uint64_t>(), j.at("to").get<std::uint64_t>()},
      j.at("of").get<std::uint64_t>(),
      Tally::restored(counts, std::stoull(j.at("digest").get<std::string>(), nullptr, 16), std::move(found))};
}

std::string contents(int file, const std::string& path) {
  std::string text;
  char buffer[1 << 16];
  for (;;) {
    const ssize_t got = ::read(file, buffer, sizeof buffer);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw BadJournal(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
    if (got == 0) return text;
    text.append(buffer, static_cast<std::size_t>(got));
  }
}

}  // namespace

std::string difference(const Identity& theirs, const Identity& ours) {
  for (std::size_t k = 0; k < std::max(theirs.size(), ours.size()); ++k) {
    if (k >= theirs.size() || k >= ours.size() || theirs[k].first != ours[k].first)
      return "made by another version of the program";
    if (theirs[k].second != ours[k].second)
      return fmt::format("{}: {} there, {} here", ours[k].first, theirs[k].second, ours[k].second);
  }
  return {};
}

Journal::Journal(std::string path, Identity identity)
    : path_(std::move(path)), identity_(std::move(identity)) {
  file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file_ < 0) throw BadJournal(fmt::format("{}: cannot be opened: {}", path_, std::strerror(errno)));
  try {
    struct stat status {};
    if (fstat(file_, &status) != 0 || !S_ISREG(status.st_mode))
      throw BadJournal(fmt::format("{}: a journal is a regular file", path_));
    if (flock(file_, LOCK_EX | LOCK_NB) != 0)
      throw BadJournal(fmt::format("{}: another run is writing to it", path_));
    read(contents(file_, path_));
    if (ftruncate(file_, static_cast<off_t>(size_)) != 0)
      throw BadJournal(
          fmt::format("{}: cannot be cut to its last whole line: {}", path_, std::strerror(errno)));
    if (size_ == 0) {
      write_line(text_of(to_json(identity_)));
      flush();
    }
  } catch (...) {
    close(file_);
    throw;
  }
}

Journal::~Journal() {
  fsync(file_);
  close(file_);
}

void Journal::read(const std::string& text) {
  std::size_t at = 0;
  for (std::size_t end; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
    const auto json = checked(text.substr(at, end - at));
    if (at == 0) {
      if (!json || json->value("schema", "") != schema)
        throw BadJournal(
            fmt::format("{}: not a journal: its first line is not that of one; name another file", path_));
      if (const std::string what = difference(identity_of(*json), as_written(identity_)); !what.empty())
        throw BadJournal(fmt::format("{}: the journal of another run ({}); name another file", path_, what));
    } else {
      try {
        if (!json) throw BadJournal("a damaged line");
        pieces_.push_back(piece(*json));
      } catch (const std::exception&) {
        dropped_ += end + 1 - at;  // each line stands alone: the others still count
      }
    }
  }
  // A first line that was cut short is a prefix of ours; anything else is somebody's file.
  if (at == 0 && !line_of(text_of(to_json(identity_))).starts_with(text))
    throw BadJournal(
        fmt::format("{}: not a journal, or the journal of another run; name another file", path_));
  size_ = at;
  dropped_ += text.size() - at;
}

std::vector<Journal::Piece> Journal::finished(const std::string& about, std::uint64_t of) const {
  const std::string written = as_written(about);
  std::vector<Piece> found;
  for (const Piece& p : pieces_)
    if (p.about == written && p.of == of && p.units.begin < p.units.end && p.units.end <= of)
      found.push_back(p);
  std::sort(found.begin(), found.end(),
            [](const Piece& a, const Piece& b) { return a.units.begin < b.units.begin; });
  std::vector<Piece> disjoint;
  for (Piece& p : found)
    if (disjoint.empty() || disjoint.back().units.end <= p.units.begin) disjoint.push_back(std::move(p));
  return disjoint;
}

void Journal::append(const Piece& piece) {
  const std::string json = text_of(to_json(piece));
  const std::lock_guard hold(lock_);
  write_line(json);
  if (std::chrono::steady_clock::now() - flushed_ < 250ms) return;
  if (fdatasync(file_) != 0)
    throw BadJournal(fmt::format("{}: cannot be written to the disk: {}", path_, std::strerror(errno)));
  flushed_ = std::chrono::steady_clock::now();
}

void Journal::discard() {
  const std::lock_guard hold(lock_);
  pieces_.clear();
  if (ftruncate(file_, 0) != 0)
    throw BadJournal(fmt::format("{}: cannot be emptied: {}", path_, std::strerror(errno)));
  size_ = 0;
  write_line(to_json(identity_).dump());
}

void Journal::flush() {
  const std::lock_guard hold(lock_);
  if (fdatasync(file_) != 0)
    throw BadJournal(fmt::format("{}: cannot be written to the disk: {}", path_, std::strerror(errno)));
}

void Journal::write_line(const std::string& json) {
  const std::string line = line_of(json);
  for (std::size_t at = 0; at < line.size();) {
    const ssize_t written = write(file_, line.data() + at, line.size() - at);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      const int error = errno;
      // A partial line must not precede the next run's first line.
      if (ftruncate(file_, static_cast<off_t>(size_)) != 0) errno = error;
      throw BadJournal(
          fmt::format("{}: cannot be written: {}; what it holds is whole", path_, std::strerror(error)));
    }
    at += static_cast<std::size_t>(written);
  }
  size_ += line.size();
}

}  // namespace mmverify::proofs
