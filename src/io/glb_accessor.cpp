#include "io/glb_accessor.h"

#include "dlfl/errors.h"

#include <fmt/format.h>

#include <string_view>

namespace druse {

namespace {

bool holds_indices(const tinygltf::Accessor& accessor)
{
    return accessor.type == TINYGLTF_TYPE_SCALAR && (accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                                                     accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                                                     accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
}

/// In single precision, or with KHR_mesh_quantization in small whole numbers.
bool holds_positions(const tinygltf::Accessor& accessor)
{
    return accessor.type == TINYGLTF_TYPE_VEC3 && (accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT ||
                                                   (accessor.componentType >= TINYGLTF_COMPONENT_TYPE_BYTE &&
                                                    accessor.componentType <= TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT));
}

GlbValues values(const tinygltf::Model& gltf, const GlbFile& file, int number, bool (*right)(const tinygltf::Accessor&),
                 const char* what, const std::string& name)
{
    check_glb_index(number, gltf.accessors.size(), "accessor", name);
    const tinygltf::Accessor& accessor = gltf.accessors[static_cast<std::size_t>(number)];
    if (!right(accessor)) throw InputError(name, fmt::format("accessor {} does not hold {}", number, what));
    if (accessor.sparse.isSparse) throw InputError(name, fmt::format("accessor {} is sparse, which is not read", number));
    check_glb_index(accessor.bufferView, gltf.bufferViews.size(), "bufferView", name);
    const tinygltf::BufferView& view = gltf.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    check_glb_index(view.buffer, file.buffers().size(), "buffer", name);
    std::string_view bytes = file.buffers()[static_cast<std::size_t>(view.buffer)];
    if (view.byteOffset > bytes.size() || view.byteLength > bytes.size() - view.byteOffset)
        throw InputError(
            name, fmt::format("bufferView {} reaches beyond the {} bytes of its buffer", accessor.bufferView, bytes.size()));
    bytes = bytes.substr(view.byteOffset, view.byteLength);

    // Nothing is multiplied or added before it is known to be small: a file can name any number.
    const auto parts = accessor.type == TINYGLTF_TYPE_VEC3 ? 3 : 1;
    const auto element =
        static_cast<std::size_t>(parts * tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)));
    const std::size_t stride = view.byteStride == 0 ? element : view.byteStride;
    bool inside = stride >= element && accessor.byteOffset <= bytes.size();
    if (inside && accessor.count > 0) {
        const std::size_t room = bytes.size() - accessor.byteOffset;
        inside = element <= room && accessor.count - 1 <= (room - element) / stride;
    }
    if (!inside)
        throw InputError(name, fmt::format("accessor {} reaches beyond the {} bytes of its bufferView", number, bytes.size()));
    return {bytes.data() + accessor.byteOffset, stride, accessor.count, accessor.componentType, accessor.normalized};
}

} // namespace

GlbValues glb_positions(const tinygltf::Model& gltf, const GlbFile& file, int accessor, const std::string& name)
{
    return values(gltf, file, accessor, holds_positions, "positions", name);
}

GlbValues glb_indices(const tinygltf::Model& gltf, const GlbFile& file, int accessor, const std::string& name)
{
    return values(gltf, file, accessor, holds_indices, "indices", name);
}

void check_glb_index(int index, std::size_t count, const char* what, const std::string& name)
{
    if (index < 0 || static_cast<std::size_t>(index) >= count)
        throw InputError(name, fmt::format("there is no {} {}, the file has {}", what, index, count));
}

} // namespace druse
