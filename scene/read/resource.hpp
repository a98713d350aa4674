// What a URI in a document names.
#pragma once

#include <filesystem>
#include <string>

#include "scene/read/buffers.hpp"

namespace mmverify::scene {

/// Whether the URI holds its bytes itself.
bool is_data_uri(const std::string& uri);

/// The bytes that a URI names: its own, in base64, or those of a file beside the document.
/// Errors: BadScene where it holds or names none, and for a file beside a document in memory.
Bytes read_resource(const Document& document, const std::string& uri, const std::string& place);

/// Whether a URI names a file beside the document, and there is nothing of that name.
/// Errors: BadScene where it names none.
bool is_missing(const Document& document, const std::string& uri, const std::string& place);

/// The same errors as of reading, but for what a data URI holds, without reading.
void check_resource(const Document& document, const std::string& uri, const std::string& place);

/// Errors: BadScene where files of images are missing; several are named at once, as whoever copies them needs all.
void check_images_there(const Document& document);

/// The bytes of images[image]; `at` is its place, for messages.  Errors: BadScene where there are none.
Bytes image_bytes(const Document& document, const Buffers& buffers, std::size_t image, const std::string& at);

/// Its name; else its URI, unless that holds its bytes.
std::string image_name(const Document& document, std::size_t image);

}  // namespace mmverify::scene
