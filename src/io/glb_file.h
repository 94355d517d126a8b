#pragma once

#include "io/byte_source.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace druse {

/// A glTF file taken apart: its description and the bytes that this refers to.
class GlbFile {
public:
    /// Reads it all. Throws InputError if the containers do not hold what they promise, or the description is no JSON.
    explicit GlbFile(ByteSource& source);
    GlbFile(const GlbFile&) = delete;
    GlbFile& operator=(const GlbFile&) = delete;

    /// The description as JSON of harmless depth, without buffers, and without images and what else we have no use for.
    const std::string& description() const { return description_; }
    /// The bytes of each buffer.
    std::span<const std::string_view> buffers() const { return buffers_; }

private:
    std::string description_;
    std::vector<std::string_view> buffers_;
    std::vector<std::vector<char>> kept_; // what the buffers lie in: this file, others beside it, and what was coded in text
};

} // namespace druse
