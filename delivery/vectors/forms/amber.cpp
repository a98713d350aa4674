// Scripts for Amber, which runs shaders on Vulkan and compares buffers: two pipelines of one compute shader each, so that
// neither binds more than four storage buffers, the least that Vulkan lets a device offer.
#include <map>
#include <stdexcept>

#include "delivery/vectors/forms/forms.hpp"
#include "delivery/vectors/forms/part.hpp"

namespace mmverify::vectors {
namespace {

constexpr std::size_t threads = 64, in_a_line = 12;

/// The function between the marks, but for the line that decides the upper half.
constexpr const char* function_begin = R"(uint spread(uint x) {  // bit k becomes bit 2k
  x = (x | x << 8) & 0x00ff00ffu;
  x = (x | x << 4) & 0x0f0f0f0fu;
  x = (x | x << 2) & 0x33333333u;
  return (x | x << 1) & 0x55555555u;
}

uint index_of(uint level, float u, float v) {
  uint last = (1u << level) - 1u;
  precise float x = clamp(u, 0.0, 1.0) * float(last + 1u), y = clamp(v, 0.0, 1.0) * float(last + 1u);
  precise float fu = x - floor(x), fv = y - floor(y);
)";
constexpr const char* upper_half[] = {
    "  // Exact: the difference has no rounding error from max = 1/2 on, and below 1/2 the answer is no.\n"
    "  precise float rest = 1.0 - max(fu, fv);\n"
    "  uint upper = min(fu, fv) >= rest ? 1u : 0u;\n",
    "  precise float sum = fu + fv;  // may round up to 1\n"
    "  uint upper = sum >= 1.0 ? 1u : 0u;\n",
};
constexpr const char* function_end = R"(  uint row = min(uint(x) + uint(y) + upper, last);
  uint iv = min(uint(y), last), iu = min(uint(x), last - iv);
  uint b0 = iu ^ row, t = (iu ^ iv) & b0, f = t;
  f ^= f >> 1;
  f ^= f >> 2;
  f ^= f >> 4;
  f ^= f >> 8;
  return spread(b0) | spread(((f ^ iu) & ~b0) | t) << 1;
}
)";

/// The place of each column's first word in a record.
std::map<std::string, std::size_t> places_of(const Table& table) {
  std::map<std::string, std::size_t> places;
  std::size_t at = 0;
  for (const Column& column : table.columns) {
    places[column.name] = at;
    at += words_of(column.kind);
  }
  return places;
}

const Column& column_of(const Table& table, const std::string& name) {
  for (const Column& column : table.columns)
    if (column.name == name) return column;
  throw std::logic_error("vectors: " + table.name + " has no column " + name);
}

class Script {
 public:
  Script(const Family& family, Dialect dialect)
      : family_(family),
        points_(family.tables.at(0)),
        places_(places_of(points_)),
        answer_(dialect == Dialect::exact ? "exact" : "published"),
        dialect_(dialect),
        on_(column_of(points_, "on").names),
        finds_(column_of(points_, "finds").names) {}

  std::string text(const Provenance& made_by) const {
    return head(made_by) + shader_that_asks() + shader_that_counts() + points() + marks() + expected() +
           run();
  }

 private:
  std::uint32_t word(std::size_t record, const std::string& column, std::size_t more = 0) const {
    return points_.record(record)[places_.at(column) + more];
  }
  std::size_t count() const { return points_.records(); }
  std::size_t counters() const { return on_.size() + finds_.size(); }

  std::string head(const Provenance& made_by) const {
    return "#!amber\n"
           "# Judges an index function: level, u and v to the number of a micro-triangle.  Made by "
           "mmverify " +
           made_by.version + " from\n# specification " + made_by.spec_hash + ",\n# family " + family_.name +
           ", version " + std::to_string(family_.version) + ", SHA-256 " + digest(family_, made_by) +
           ".\n# MIT licence.\n#\n"
           "# Put your function, uint index_of(uint level, float u, float v), between the two marks, and "
           "run\n"
           "#   amber " +
           amber_names[static_cast<std::size_t>(dialect_)] + "\n# The expectations are those of column `" +
           answer_ + "`. The function that stands there now meets them.\n\n";
  }

  std::string shader_that_asks() const {
    return "SHADER compute asks GLSL\n#version 450\nlayout(local_size_x = " + std::to_string(threads) +
           ") in;\nlayout(set = 0, binding = 0, std430) readonly buffer Points { uint points[]; };\n"
           "layout(set = 0, binding = 1, std430) buffer Answers { uint answers[]; };\n\n" +
           amber_mark_begin + "\n" + function_begin + upper_half[static_cast<std::size_t>(dialect_)] +
           function_end + amber_mark_end +
           "\n\nvoid main() {\n  uint k = gl_GlobalInvocationID.x;\n  if (k < " + std::to_string(count()) +
           "u)\n    answers[k] = index_of(points[3u * k], uintBitsToFloat(points[3u * k + 1u]),\n"
           "                          uintBitsToFloat(points[3u * k + 2u]));\n}\nEND\n\n";
  }

  /// Counter i < 4 has the wrong answers of kind i, counter 4 + k those of vectors that find mistake k.
  std::string shader_that_counts() const {
    const std::string kinds = std::to_string(on_.size()) + "u";
    return "SHADER compute counts GLSL\n#version 450\nlayout(local_size_x = " + std::to_string(threads) +
           ") in;\nlayout(set = 0, binding = 0, std430) readonly buffer Answers { uint answers[]; };\n"
           "layout(set = 0, binding = 1, std430) readonly buffer Expected { uint expected[]; };\n"
           "layout(set = 0, binding = 2, std430) readonly buffer Marks { uint marks[]; };\n"
           "layout(set = 0, binding = 3, std430) buffer Wrong { uint wrong[]; };\n\n"
           "void main() {\n  uint k = gl_GlobalInvocationID.x;\n  if (k >= " +
           std::to_string(count()) +
           "u || answers[k] == expected[k]) return;\n"
           "  atomicAdd(wrong[marks[2u * k]], 1u);\n  for (uint i = 0u; i < " +
           std::to_string(finds_.size()) +
           "u; ++i)\n    if ((marks[2u * k + 1u] >> i & 1u) == 1u) atomicAdd(wrong[" + kinds +
           " + i], 1u);\n}\nEND\n\n";
  }

  /// A line a vector: level, u, v.
  std::string points() const {
    std::string out =
        "# level, bits of u, bits of v # vector: on what the point lies: why the vector is there; mistakes "
        "that it finds\n"
        "BUFFER points DATA_TYPE uint32 DATA\n";
    for (std::size_t k = 0; k < count(); ++k) {
      out += std::to_string(word(k, "level")) + " 0x" + hex(word(k, "u")) + " 0x" + hex(word(k, "v")) +
             " # " + std::to_string(k) + ": " + on_.at(word(k, "on")) + ": " +
             family_.abouts.at(word(k, "about"));
      const char* before = "; finds ";
      for (std::size_t i = 0; i < finds_.size(); ++i)
        if ((word(k, "finds") >> i & 1) != 0) out += before + finds_[i], before = " ";
      out += "\n";
    }
    return out + "END\n\n";
  }

  /// Numbers, `in_a_line` a line, each line with the vector that it begins with.
  template <class Number>
  std::string numbers(const char* name, std::size_t of_a_vector, Number number) const {
    std::string out = std::string("BUFFER ") + name + " DATA_TYPE uint32 DATA\n";
    for (std::size_t k = 0; k < count() * of_a_vector; ++k) {
      const bool first = k % in_a_line == 0,
                 last = (k + 1) % in_a_line == 0 || k + 1 == count() * of_a_vector;
      out += (first ? "" : " ") + std::to_string(number(k));
      if (last) out += " # from " + std::to_string((k - k % in_a_line) / of_a_vector) + "\n";
    }
    return out + "END\n\n";
  }

  std::string marks() const {
    std::string out = "# For each vector two marks.  The first: on what the point lies.  0 interior";
    for (std::size_t k = 1; k < on_.size(); ++k) out += ", " + std::to_string(k) + " " + on_[k];
    out += ": 1 and 2 are ties.\n# The second: the mistakes that it finds.\n";
    for (std::size_t k = 0; k < finds_.size(); ++k)
      out += "#   bit " + std::to_string(k) + " " + finds_[k] + "\n";
    return out + numbers("marks", 2, [this](std::size_t k) {
             return k % 2 == 0 ? word(k / 2, "on") : word(k / 2, "finds");
           });
  }

  std::string expected() const {
    return numbers("expected", 1, [this](std::size_t k) { return word(k, answer_); });
  }

  std::string run() const {
    const std::string groups = std::to_string((count() + threads - 1) / threads);
    const auto bind = [](const char* buffer, int binding) {
      return std::string("  BIND BUFFER ") + buffer + " AS storage DESCRIPTOR_SET 0 BINDING " +
             std::to_string(binding) + "\n";
    };
    std::string out =
        "BUFFER answers DATA_TYPE uint32 SIZE " + std::to_string(count()) +
        " FILL 4294967295\nBUFFER wrong DATA_TYPE uint32 SIZE " + std::to_string(counters()) +
        " FILL 0\n\nPIPELINE compute ask\n  ATTACH asks\n" + bind("points", 0) + bind("answers", 1) +
        "END\n\nPIPELINE compute count\n  ATTACH counts\n" + bind("answers", 0) + bind("expected", 1) +
        bind("marks", 2) + bind("wrong", 3) + "END\n\nRUN ask " + groups + " 1 1\nRUN count " + groups +
        " 1 1\n\n# Numbers of wrong answers: by what the point lies on, then by mistake.  Amber stops "
        "at the first line that\n# fails, and prints its number.\n";
    for (std::size_t k = 0; k < on_.size(); ++k)
      out += "EXPECT wrong IDX " + std::to_string(4 * k) + " EQ 0 # " + on_[k] + "\n";
    for (std::size_t k = 0; k < finds_.size(); ++k)
      out += "EXPECT wrong IDX " + std::to_string(4 * (on_.size() + k)) + " EQ 0 # " + finds_[k] + "\n";
    return out + "\nEXPECT answers EQ_BUFFER expected\n";
  }

  const Family& family_;
  const Table& points_;
  std::map<std::string, std::size_t> places_;
  std::string answer_;
  Dialect dialect_;
  std::vector<std::string> on_, finds_;
};

}  // namespace

std::string as_amber(const Family& index, Dialect dialect, const Provenance& made_by) {
  if (index.name != amber_family) throw std::logic_error("vectors: no script for family " + index.name);
  return Script(index, dialect).text(made_by);
}

}  // namespace mmverify::vectors
