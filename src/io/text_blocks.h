#pragma once

#include "io/byte_source.h"

#include <memory>

namespace druse {

/// Hands out a text in blocks of whole lines, through one buffer that is used again and again: a file of any size costs a
/// megabyte, and no page of memory is touched for the first time after the first block.
class TextBlocks {
public:
    explicit TextBlocks(ByteSource& source);

    /// The next lines, at most about a megabyte of them but at least one; false after the last. The block stays valid until the
    /// next call and ends in a line break, the last one too; a line that goes on after a backslash is not cut there.
    bool next(const char*& begin, const char*& end);

private:
    ByteSource& source_;
    std::unique_ptr<char[]> buffer_;
    std::size_t capacity_;
    std::size_t filled_ = 0, used_ = 0;
    bool at_end_ = false;
};

} // namespace druse
