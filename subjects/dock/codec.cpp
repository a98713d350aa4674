#include "subjects/dock/codec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cstring>

#include "subjects/dock/broken.hpp"

namespace mmverify::dock {
namespace {

/// Copies elements [from, from + count) into a worker's inputs and asks about them.
void ask_piece(const Library& library, const Lookup& l, std::uint64_t from, std::uint64_t count,
               std::uint8_t* out) {
  Borrowed worker(library.pool());
  const std::size_t bytes = entry_point(l.call).signature.number_bytes;
  for (std::size_t a = 0; a < l.arrays.size(); ++a)
    std::memcpy(worker->input(l.call, a, count, 0), static_cast<const std::byte*>(l.arrays[a]) + from * bytes,
                count * bytes);
  const Reply reply =
      worker->ask(Question{l.call, l.level, l.format, l.code, static_cast<std::size_t>(count), count});
  std::copy(reply.bytes.begin(), reply.bytes.end(), out);
  worker.give_back();
}

/// Asks about each element alone, to name the first one that misbehaves; `found` if none does alone.
Misbehaved pinned_down(const Library& library, const Lookup& l, std::uint64_t from, const Misbehaved& found) {
  std::uint8_t ignored = 0;
  for (std::uint64_t t = 0; found.count > 1 && t < found.count; ++t) try {
      ask_piece(library, l, from + t, 1, &ignored);
    } catch (const Misbehaved& alone) {
      return {alone.what, t, 1};
    }
  return found;
}

std::string hex_text(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t shown = 32;
  if (bytes.empty()) return "of 0 bytes";
  std::string text = fmt::format("{:02x}", fmt::join(bytes.first(std::min(shown, bytes.size())), " "));
  if (bytes.size() <= shown) return text;
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return text + fmt::format(" ... ({} bytes, crc {:08x})", bytes.size(), crc.checksum());
}

}  // namespace

Answer ask(const Library& library, const Question& question, const std::function<std::string()>& doing) {
  Borrowed worker(library.pool());
  try {
    const Reply reply = worker->ask(question);
    Answer answer{reply.taken, {reply.bytes.begin(), reply.bytes.end()}};
    worker.give_back();
    return answer;
  } catch (const Misbehaved& found) {
    throw CaseBroken(fmt::format("{} at level {} {}", found.what, question.level, doing()), found.hung);
  }
}

void look_up(const Library& library, const Lookup& l, std::span<std::uint8_t> out) {
  for (std::uint64_t from = 0; from < out.size(); from += batch_size) try {
      ask_piece(library, l, from, std::min<std::uint64_t>(batch_size, out.size() - from), out.data() + from);
    } catch (const Misbehaved& first) {
      const Misbehaved found = pinned_down(library, l, from, first);
      const std::string one = l.element(from + found.first);
      throw CaseBroken(
          fmt::format("{} at level {} looking up {} in {}", found.what, l.level,
                      found.count == 1 ? one
                                       : fmt::format("{} cases from {} to {}", found.count, one,
                                                     l.element(from + found.first + found.count - 1)),
                      code_text(l.format, l.code)),
          found.hung);
    }
}

std::string map_text(std::uint32_t format, std::uint64_t states, std::span<const std::uint8_t> packed) {
  if (states > 256) return fmt::format("the {}-state map {}", 1u << format, hex_text(packed));
  std::string text = fmt::format("{}-state:", 1u << format);
  for (std::uint64_t k = 0; k < states; ++k)
    text += static_cast<char>('0' + (packed[k * format / 8] >> k * format % 8 & ((1u << format) - 1)));
  return text;
}

std::string code_text(std::uint32_t format, std::span<const std::uint8_t> code) {
  if (format == 0) return "block:" + fmt::format("{:02x}", fmt::join(code, ""));
  return fmt::format("the {}-state code {}", 1u << format, hex_text(code));
}

}  // namespace mmverify::dock
