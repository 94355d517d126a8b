// The bodies of tinygltf, which comes as one header.
#include <fstream> // which it forgets without its ways to files

#define TINYGLTF_IMPLEMENTATION
#include "io/glb_library.h"
