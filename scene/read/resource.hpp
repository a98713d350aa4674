// The bytes and files that URIs in a document name.
#pragma once

#include <string>

#include "scene/read/buffers.hpp"

namespace mmverify::scene {

/// Whether the URI contains its bytes itself.
bool is_data_uri(const std::string& uri);

/// The bytes that a URI names: its own, in base64, or those of a file beside the document.
/// Errors: BadScene if the URI has or names none, and for a file beside a document in memory.
Bytes read_resource(const Document& document, const std::string& uri, const std::string& place);

/// Whether a URI names a file beside the document that does not exist.
/// Errors: BadScene if the URI names no such place.
bool is_missing(const Document& document, const std::string& uri, const std::string& place);

/// Checks a URI without reading.  Errors: as of read_resource(), but for the contents of a data URI.
void check_resource(const Document& document, const std::string& uri, const std::string& place);

/// Errors: BadScene if several files of images are missing; it names them together, since all have to be
/// copied.  A single missing file is left to its reader.
void check_images_there(const Document& document);

/// The bytes of images[image]; `at` is its place, for messages.  Errors: BadScene if there are none.
Bytes image_bytes(const Document& document, const Buffers& buffers, std::size_t image, const std::string& at);

/// The name of an image, or else its URI, unless that contains the bytes.
std::string image_name(const Document& document, std::size_t image);

}  // namespace mmverify::scene
