// The headers tinygltf and stb, compiled here if no library has them: with the flags of the fuzz targets
// (MMVERIFY_ONLY_FUZZ), so that sanitizers and the fuzzer see into them, and for WebAssembly.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define TINYGLTF_IMPLEMENTATION
// tinygltf would include these by other names than the distribution's.
#define TINYGLTF_NO_INCLUDE_JSON
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <nlohmann/json.hpp>

// The headers that it must not include come first.
#include <tiny_gltf.h>
