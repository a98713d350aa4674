// The extensions that a file requires: which of them are read, and what the others are on.
#pragma once

#include <string>

#include "scene/read/document.hpp"

namespace mmverify::scene {

/// Whether an extension is read, or changes nothing that is read here, such as shading, lights and metadata.
bool is_read_or_harmless(std::string_view extension);

/// Refuses an object that is read here if it has an extension that the file requires and that is not read
/// here.  A required name that stands on no such object does not matter.
/// `at` is the object's place, for messages.  Errors: UnreadExtension.
/// Source: glTF 2.0, 3.12.
void check_extensions(const Document& document, const nlohmann::json& object, const std::string& at);

}  // namespace mmverify::scene
