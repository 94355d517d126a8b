#pragma once

#include "dlfl/group_table.h"
#include "dlfl/mesh.h"
#include "dlfl/rind.h"
#include "ops/source.h"

#include <memory>
#include <vector>

namespace druse {

/// A value that copies share until one of them is edited; so a history step that does not touch it costs a pointer.
template <class T>
class Shared {
public:
    Shared() : value_(std::make_shared<const T>()) {}
    Shared(T value) : value_(std::make_shared<const T>(std::move(value))) {}

    const T& operator*() const { return *value_; }
    const T* operator->() const { return value_.get(); }
    /// The value for writing; other copies keep what they had.
    T& edit()
    {
        auto own = std::make_shared<T>(*value_);
        T& result = *own;
        value_ = std::move(own);
        return result;
    }
    bool same_as(const Shared& other) const { return value_ == other.value_; }

private:
    std::shared_ptr<const T> value_;
};

/// What is selected: three lists, each ascending and without repeats.
struct Selection {
    std::vector<Face> faces;
    std::vector<Edge> edges;
    std::vector<Vertex> vertices;

    friend bool operator==(const Selection&, const Selection&) = default;
};

/// What an operator may change: one mesh, which of its faces are a crust's, its groups, what is selected, and at most one source.
struct Scene {
    Mesh mesh;
    Rind rind;
    Shared<GroupTable> groups;
    Shared<Selection> selection;
    HeldSource source;
};

/// Closes the holes of the mesh; the selection and the rind keep what is left of them, by its new ids. Cost: O(selection) where there are none.
void settle(Scene& scene);

} // namespace druse
