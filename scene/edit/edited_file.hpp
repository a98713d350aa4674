// A glTF file that is changed in places, and stays as it is elsewhere.
#pragma once

#include <map>
#include <set>
#include <string>

#include "scene/read/buffers.hpp"

namespace mmverify::scene {

/// The files that a changed glTF file becomes.
struct WrittenFile {
  Bytes bytes;                           ///< of the .gltf or .glb
  std::map<std::string, Bytes> buffers;  ///< changed buffers in files of their own, by URI
};

class EditedFile {
 public:
  /// Errors: BadScene.
  explicit EditedFile(const std::string& file);

  const Document& document() const { return document_; }
  const Bytes& original() const { return original_; }
  /// The document's JSON; whatever is changed in it is changed in the file.
  nlohmann::json json;

  /// The current bytes of a bufferView, decoded where they are compressed.
  /// Errors: BadScene if they lie outside their buffer, or cannot be decoded.
  std::span<const unsigned char> view(std::size_t view) const;

  /// Whether at most one accessor, image, micromap or extension reads the bytes [offset, offset + size) of a bufferView.
  bool is_alone(std::size_t view, std::uint64_t offset, std::uint64_t size) const;

  /// Puts bytes over those of a bufferView, from `offset` on.  A compressed view becomes a plain one, at the end of the
  /// buffer that has its code.  Domain: within the view, and is_alone().
  void overwrite(std::size_t view, std::uint64_t offset, std::span<const unsigned char> bytes);

  /// Gives a bufferView other bytes: in place where they are as many, or the view ends its buffer; else at its buffer's
  /// end, as those of a compressed view.  Domain: a view that is_alone().
  void replace(std::size_t view, std::span<const unsigned char> bytes);

  /// Appends bytes to a buffer, at a multiple of 4, as a new bufferView; its number.
  std::size_t add_view(std::size_t buffer, std::span<const unsigned char> bytes);

  bool is_compressed(std::size_t view) const;

  /// The buffer that has a view's bytes, or their code.
  std::size_t buffer_of(std::size_t view) const;

  /// The bufferViews to which nothing refers.
  std::vector<std::size_t> unread_views() const;

  /// Whether anything was changed so far.
  bool is_changed() const;

  /// URIs of buffers and images in files of their own.
  std::set<std::string> uris() const;

  /// The changed file.  A buffer in the JSON as base64 stays there.
  /// Errors: std::length_error if a GLB would have 2^32 bytes or more.
  WrittenFile written() const;

  /// The changed file as a document; what did not change is read from beside the file.
  /// Errors: BadScene.
  Document reopened(const WrittenFile& written) const;

 private:
  /// Appends bytes to a buffer; their offset.
  std::uint64_t append(std::size_t buffer, std::span<const unsigned char> bytes);
  std::string json_text(const nlohmann::json& changed) const;
  /// Stores a compressed view plain, with these bytes.
  void store_plain(std::size_t view, std::span<const unsigned char> bytes);

  std::string file_;
  Bytes original_;
  Document document_;
  std::vector<Bytes> buffers_;
  mutable std::map<std::size_t, Bytes> decoded_;  ///< compressed views that were asked for
  std::set<std::size_t> changed_;                 ///< numbers of buffers
};

}  // namespace mmverify::scene
