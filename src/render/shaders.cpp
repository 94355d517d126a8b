#include "render/shaders.h"

#include "dlfl/errors.h"

namespace druse {

namespace {

GLuint compile(const GlApi& gl, GLenum kind, const std::string& defines, const char* source)
{
    const std::string head = "#version 330 core\n" + defines;
    const char* parts[] = {head.c_str(), source};
    const GLuint shader = gl.CreateShader(kind);
    gl.ShaderSource(shader, 2, parts, nullptr);
    gl.CompileShader(shader);
    GLint good = 0;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good) {
        char log[2048] = "";
        gl.GetShaderInfoLog(shader, sizeof log, nullptr, log);
        throw InternalError(std::string("a shader does not compile: ") + log);
    }
    return shader;
}

} // namespace

Program::Program(const GlApi& gl, const std::string& defines, const char* vertex_source, const char* fragment_source) : gl_(gl)
{
    const GLuint vertex = compile(gl, GL_VERTEX_SHADER, defines, vertex_source);
    const GLuint fragment = compile(gl, GL_FRAGMENT_SHADER, defines, fragment_source);
    id_ = gl.CreateProgram();
    gl.AttachShader(id_, vertex);
    gl.AttachShader(id_, fragment);
    gl.LinkProgram(id_);
    gl.DeleteShader(vertex);
    gl.DeleteShader(fragment);
    GLint good = 0;
    gl.GetProgramiv(id_, GL_LINK_STATUS, &good);
    if (!good) {
        char log[2048] = "";
        gl.GetProgramInfoLog(id_, sizeof log, nullptr, log);
        throw InternalError(std::string("a shader program does not link: ") + log);
    }
}

// Light goes with the eye: a key light from above its left shoulder, a weak one from the right, and light from everywhere, so
// that the three faces of a cube seen from a corner differ, and no face is black.
const char* const light_source = R"glsl(
float light(vec3 n)
{
    return 0.40 + 0.50 * max(dot(n, vec3(-0.45, 0.55, 0.70)), 0.0) + 0.13 * max(dot(n, vec3(0.65, -0.10, 0.75)), 0.0);
}
)glsl";

// Faces. All that is the same over a triangle is worked out at its last vertex and handed on flat: light, colour, and for the
// edges the lines in the picture that carry its three sides. A fragment only measures how far it is from those.
//
// Side lines are kept in homogeneous form (the cross product of the two ends), so an end behind the eye needs no special case.
const char* const faces_vertex_source = R"glsl(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 colour;
layout(location = 3) in uint flags;
uniform mat4 to_clip;
uniform mat3 to_eye;
uniform vec3 selected_colour;
uniform vec4 paint; // in place of the colour, if its last is 1
flat out vec3 front;
#ifdef BOTH_SIDES
flat out vec3 back;
#endif
#ifdef SMOOTH
layout(location = 6) in vec4 vertex_normal;
out vec3 bent;
#endif
#ifdef EDGES
layout(location = 4) in vec3 second;
layout(location = 5) in vec3 third;
uniform vec2 half_size;
flat out vec3 side0, side1, side2;
vec3 pixel(vec4 clip) { return vec3(clip.xy * half_size, clip.w); }
vec3 side(vec3 a, vec3 b, uint flag)
{
    vec3 line = cross(a, b);
    return (flags & flag) != 0u ? line * inversesqrt(dot(line.xy, line.xy) + 1e-30) : vec3(0.0, 0.0, 1e6);
}
#endif
void main()
{
    vec4 clip = to_clip * vec4(position, 1.0);
    gl_Position = clip;
    vec3 base = mix(colour.rgb, paint.rgb, paint.a);
    if ((flags & 8u) != 0u) base = mix(base, selected_colour, 0.42);
#ifdef SMOOTH
    bent = to_eye * vertex_normal.xyz;
    front = base;
#ifdef BOTH_SIDES
    back = base * vec3(0.62, 0.58, 0.58);
#endif
#else
    vec3 n = to_eye * normal.xyz;
    front = base * light(n);
#ifdef BOTH_SIDES
    back = base * light(-n) * vec3(0.62, 0.58, 0.58);
#endif
#endif
#ifdef EDGES
    vec3 a = pixel(clip), b = pixel(to_clip * vec4(second, 1.0)), c = pixel(to_clip * vec4(third, 1.0));
    side0 = side(a, b, 1u);
    side1 = side(b, c, 2u);
    side2 = side(c, a, 4u);
#endif
}
)glsl";

const char* const faces_fragment_source = R"glsl(
flat in vec3 front;
uniform float opacity;
#ifdef BOTH_SIDES
flat in vec3 back;
#endif
#ifdef SMOOTH
in vec3 bent;
#endif
#ifdef EDGES
flat in vec3 side0, side1, side2;
uniform vec2 half_size;
uniform vec3 edge_colour;
uniform float edge_strength, edge_half_width;
#endif
out vec4 result;
void main()
{
#ifdef BOTH_SIDES
    vec3 shown = gl_FrontFacing ? front : back;
#else
    vec3 shown = front;
#endif
#ifdef SMOOTH
    vec3 n = normalize(bent);
#ifdef BOTH_SIDES
    if (!gl_FrontFacing) n = -n;
#endif
    shown *= light(n);
#endif
#ifdef EDGES
    vec3 p = vec3(gl_FragCoord.xy - half_size, 1.0);
    float away = min(min(abs(dot(side0, p)), abs(dot(side1, p))), abs(dot(side2, p)));
    shown = mix(shown, edge_colour, edge_strength * clamp(edge_half_width + 0.5 - away, 0.0, 1.0));
#endif
    result = vec4(shown, opacity);
}
)glsl";

const char* const lines_vertex_source = R"glsl(
layout(location = 0) in vec3 position;
uniform mat4 to_clip;
void main() { gl_Position = to_clip * vec4(position, 1.0); }
)glsl";

const char* const lines_fragment_source = R"glsl(
uniform vec4 colour;
out vec4 result;
void main() { result = colour; }
)glsl";

// Lines thicker than a pixel: one rectangle per line, wide enough for its round ends, in which a fragment measures its distance
// to the line. No width beyond 1 is promised by glLineWidth in a core profile. Ends behind the eye are cut off at the near plane.
const char* const thick_vertex_source = R"glsl(
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 line_colour;
layout(location = 3) in float width;
uniform mat4 to_clip;
uniform vec2 half_size;
uniform float nearer;
flat out vec4 colour;
flat out vec2 start, along;
flat out float half_width;
void main()
{
    vec4 a = to_clip * vec4(from, 1.0), b = to_clip * vec4(to, 1.0);
    float near_a = a.z + a.w, near_b = b.z + b.w;
    if (near_a < 0.0 && near_b > 0.0) a = mix(a, b, near_a / (near_a - near_b));
    if (near_b < 0.0 && near_a > 0.0) b = mix(b, a, near_b / (near_b - near_a));
    if (near_a < 0.0 && near_b < 0.0) a = b = vec4(0.0, 0.0, 2.0, 1.0);
    vec3 p = a.xyz / a.w, q = b.xyz / b.w;
    start = p.xy * half_size;
    along = q.xy * half_size - start;
    half_width = 0.5 * width;
    colour = line_colour;
    float reach = half_width + 1.0, size = length(along);
    vec2 forward = size > 1e-4 ? along / size : vec2(1.0, 0.0);
    bool at_end = (gl_VertexID & 1) != 0;
    vec2 corner = (at_end ? start + along + forward * reach : start - forward * reach) +
                  ((gl_VertexID & 2) != 0 ? 1.0 : -1.0) * reach * vec2(-forward.y, forward.x);
    gl_Position = vec4(corner / half_size, max(at_end ? q.z - nearer / b.w : p.z - nearer / a.w, -1.0), 1.0);
}
)glsl";

const char* const thick_fragment_source = R"glsl(
flat in vec4 colour;
flat in vec2 start, along;
flat in float half_width;
uniform vec2 half_size;
out vec4 result;
void main()
{
    vec2 p = gl_FragCoord.xy - half_size - start;
    float t = clamp(dot(p, along) / max(dot(along, along), 1e-8), 0.0, 1.0);
    float cover = clamp(half_width + 0.5 - length(p - t * along), 0.0, 1.0);
    if (cover <= 0.0) discard;
    result = vec4(colour.rgb, colour.a * cover);
}
)glsl";

const char* const background_vertex_source = R"glsl(
out float height;
void main()
{
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    height = 0.5 + 0.5 * corner.y;
    gl_Position = vec4(corner, 1.0, 1.0);
}
)glsl";

const char* const background_fragment_source = R"glsl(
in float height;
uniform vec3 top, bottom;
out vec4 result;
void main() { result = vec4(mix(bottom, top, height), 1.0); }
)glsl";

} // namespace druse
