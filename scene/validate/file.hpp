// The validator of a file of micromaps, whatever its kind.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/read/file.hpp"
#include "scene/validate/draft.hpp"
#include "scene/validate/issues.hpp"
#include "scene/validate/micromaps.hpp"

namespace mmverify::scene {

/// The kind of a file, by its bytes, never by its name.
enum class FileKind : std::uint8_t {
  sidecar,  ///< JSON with a schema "mmverify.array/...", or with records or apis and no asset: docs/VALIDATE.md
  gltf,     ///< GLB, or any other JSON
  array,    ///< "MMARRAYS": docs/ARRAYS.md, Files
  tree,     ///< "mmtr": impl/tree/container.hpp
  dag,      ///< "mmdg": docs/DAG.md, The container
  attributes,  ///< "mmat": docs/ATTRIBUTE_FORMAT.md
};

const char* name_of(FileKind kind) noexcept;

/// The kind of bytes; none if they are of no known kind.
std::optional<FileKind> kind_of(std::span<const unsigned char> bytes);

struct Judged {
  FileKind kind;
  std::vector<Draft> drafts = {};            ///< for glTF: the drafts whose rules were checked
  std::vector<FileViolation> findings = {};  ///< each rule is a code of issues()

  std::uint64_t count(Severity severity) const;
};

/// A reader of a file that a sidecar names, by its name there.  Errors: BadScene.
using Beside = std::function<Bytes(const std::string& name)>;

/// Every finding, in the order of the file.  For one code at one place, eight are listed, then the number of
/// the others.
///   - A pointer is one of JSON; in a container "byte N", and within an array file as in a sidecar.
///   - glTF: EXT's name is judged by the newest draft, KHR's by its own, unless `draft` names one.
///   - The target's APIs take the place of those that a sidecar names, and apply to glTF and array files besides glTF's
///     rules; its device takes the place of a sidecar's limits.
///   - A container that its reader takes is one that its writer writes; the content of an array file is checked by
///     the rules of glTF.
/// Domain: everything.  O(n log n) in the bytes; for a sidecar in those of its buffers too, counting indices
/// once for each geometry that names them.
/// Errors: BadScene if the file is missing, empty, too large, or of no known kind.
Judged validate_file(const std::string& file, std::optional<Draft> draft = {}, const Target& target = {});

/// The findings for bytes in memory: a glTF file has no other files beside it, a sidecar those of `beside`.
Judged validate_file(const std::string& name, std::span<const unsigned char> bytes,
                     std::optional<Draft> draft, const Beside& beside, const Target& target = {});

}  // namespace mmverify::scene
