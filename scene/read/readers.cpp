// tinygltf and stb, which are headers, compiled with the flags of the fuzz targets (MMVERIFY_ONLY_FUZZ):
// sanitizers and the fuzzer see into them, and no library of another C++ standard library is linked.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define TINYGLTF_IMPLEMENTATION
// What it would include by other names than the distribution's.
#define TINYGLTF_NO_INCLUDE_JSON
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE

#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <nlohmann/json.hpp>

// After what it is not to include.
#include <tiny_gltf.h>
