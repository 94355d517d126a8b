#pragma once

#include "render/gl_api.h"

#include <string>

namespace druse {

/// A linked shader program. Deletes itself; its context must be current then.
class Program {
public:
    /// `defines` are lines that go before both sources. Fails an ASSERT with the driver's complaint, as the sources are ours.
    Program(const GlApi& gl, const std::string& defines, const char* vertex_source, const char* fragment_source);
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program() { gl_.DeleteProgram(id_); }

    void use() const { gl_.UseProgram(id_); }
    /// −1 (which OpenGL ignores) for a uniform that this variant does not have.
    GLint uniform(const char* name) const { return gl_.GetUniformLocation(id_, name); }

private:
    const GlApi& gl_;
    GLuint id_ = 0;
};

/// Where the vertex attributes of faces and lines are bound.
enum Attribute : GLuint { at_position, at_normal, at_colour, at_flags, at_second, at_third, at_smooth };

extern const char* const light_source;        // goes before the sources of faces
extern const char* const faces_vertex_source; // variants are defined by SMOOTH, EDGES and BOTH_SIDES
extern const char* const faces_fragment_source;
extern const char* const lines_vertex_source;
extern const char* const lines_fragment_source;
extern const char* const thick_vertex_source;
extern const char* const thick_fragment_source;
extern const char* const background_vertex_source;
extern const char* const background_fragment_source;

} // namespace druse
