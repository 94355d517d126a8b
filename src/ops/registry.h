#pragma once

#include "ops/operator.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace druse {

/// All operators, each once, in the order in which menus and the reference page list them.
class Registry {
public:
    void add(Operator op);

    const std::vector<Operator>& operators() const { return operators_; }

    /// The operator of a name: full, an alias, or without its family where no other shares the last part; `.` `-` `_` are the
    /// same. Null if there is none.
    const Operator* find(std::string_view name) const;
    /// The operator, or @throws CommandError `unknown operator 'x'; did you mean 'y'?`
    const Operator& get(std::string_view name) const;

private:
    std::vector<Operator> operators_;
    std::map<std::string, std::size_t, std::less<>> by_name_; // normalised full names and aliases
    std::multimap<std::string, std::size_t, std::less<>> by_last_part_;
};

// One function a family, each in its own file; a new family is added here and in app/registry.cpp.
void register_make(Registry& registry);
void register_face(Registry& registry);
void register_select(Registry& registry);
void register_group(Registry& registry);
void register_extrude(Registry& registry);
void register_remesh(Registry& registry);
void register_topology(Registry& registry);
void register_rind(Registry& registry);
void register_graph(Registry& registry);
void register_pane(Registry& registry);
void register_tile(Registry& registry);
void register_cell(Registry& registry);
void register_mesh(Registry& registry);
void register_check(Registry& registry);

} // namespace druse
