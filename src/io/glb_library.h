#pragma once

// tinygltf with the parts that we use: no images, and no way to files but our own. Every file that includes it must see the same
// switches; it takes seconds to compile.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS

#include <tiny_gltf.h>
