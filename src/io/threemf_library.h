#pragma once

// lib3mf as we use it: handles that release what they hold, and errors.
#include <Model/COM/NMR_DLLInterfaces.h>

#include <clocale>
#include <string>
#include <utility>

namespace druse {

using ThreeMfObject = NMR::PLib3MFBase*;

/// Holds an object of lib3mf.
class ThreeMfHandle {
public:
    ThreeMfHandle() = default;
    ThreeMfHandle(ThreeMfHandle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
    ThreeMfHandle& operator=(ThreeMfHandle&& other) noexcept
    {
        std::swap(object_, other.object_);
        return *this;
    }
    ~ThreeMfHandle()
    {
        if (object_) NMR::lib3mf_release(object_);
    }

    /// For a function that makes one.
    ThreeMfObject* out() { return &object_; }
    operator ThreeMfObject() const { return object_; }

private:
    ThreeMfObject object_ = nullptr;
};

/// A failure of lib3mf, in its own words.
struct ThreeMfError {
    std::string what;
};

/// @throws ThreeMfError unless a call on that object went well
void require_3mf(ThreeMfObject object, HRESULT result);

/// While it stands, the locale may be changed: lib3mf sets that of the whole program to read and write numbers.
class KeptLocale {
public:
    KeptLocale() : before_(std::setlocale(LC_ALL, nullptr)) {}
    ~KeptLocale() { std::setlocale(LC_ALL, before_.c_str()); }
    KeptLocale(const KeptLocale&) = delete;
    KeptLocale& operator=(const KeptLocale&) = delete;

private:
    std::string before_;
};

} // namespace druse
