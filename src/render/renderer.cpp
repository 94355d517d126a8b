#include "render/renderer.h"

#include "dlfl/errors.h"
#include "render/frame_target.h"
#include "render/gl_api.h"
#include "render/gpu_mesh.h"
#include "render/shaders.h"
#include "render/thick_line_painter.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace druse {

namespace {

constexpr std::size_t most_outlined = 20000; // sides of faces that are drawn as thick lines; a larger selection is tinted only
constexpr double edge_half_width = 0.7;      // in pixels

/// Variants of the face shader.
enum Variant : unsigned { smooth = 1, edges = 2, both_sides = 4 };

std::array<float, 3> floats(Colour c)
{
    return {float(c.red) / 255.0f, float(c.green) / 255.0f, float(c.blue) / 255.0f};
}

bool is_bright(const Style& style)
{
    const auto sum = [](Colour c) { return 2 * c.red + 5 * c.green + c.blue; };
    return sum(style.background_top) + sum(style.background_bottom) > 8 * 255;
}

/// What brings places relative to the origin of lists to where a copy has them in the picture.
glm::mat4 placed(const glm::dmat4& clip, const Point& origin, const DrawLists::Copy& copy)
{
    return glm::mat4(glm::scale(glm::translate(clip, copy.at(origin) - origin), Vector(copy.scale)));
}

} // namespace

struct Renderer::Parts {
    explicit Parts(const GlProcLoader& get);

    void draw_base(const DrawLists& lists, const Camera& camera, const Style& style);
    void draw_background(const Style& style);
    void use_faces(const Camera& camera, const Style& style);
    void draw_faces(const Style& style);
    void draw_painted(const DrawLists& lists, const Camera& camera, const Style& style, const Overlay& overlay);
    void draw_lines(const glm::mat4& to, Colour colour, double opacity);
    void draw_overlay(const DrawLists& lists, const Camera& camera, const Style& style, const Overlay& overlay);
    const Program& face_program(unsigned which);
    const Program& line_program();
    double edge_strength(const DrawLists& lists, const Camera& camera, const Style& style) const;

    GlApi gl;
    std::string driver;
    bool software = false;

    FrameTarget target{gl};
    GpuMesh mesh{gl};
    ThickLinePainter thick{gl};
    std::array<std::optional<Program>, 8> faces;
    std::optional<Program> lines, background;
    GLuint no_attributes = 0;

    // What the base shows.
    std::uint64_t shown_version = 0;
    std::optional<Camera> shown_camera;
    Style shown_style;
    Box scene; // copies included
    glm::mat4 to_clip{1.0f};
    unsigned variant = 0;      // of the face shader
    double strength = 0;       // of the edges
    bool under_lines = false;  // faces are pushed back, and edges drawn as lines over them
};

Renderer::Parts::Parts(const GlProcLoader& get) : gl(GlApi::load(get))
{
    GLint major = 0, minor = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor < 33)
        throw SystemError("OpenGL 3.3 is needed, but this context has " + std::to_string(major) + "." + std::to_string(minor));
    if (const GLubyte* name = gl.GetString(GL_RENDERER)) driver = reinterpret_cast<const char*>(name);
    for (const char* known : {"llvmpipe", "softpipe", "swrast", "SWR"})
        if (driver.find(known) != std::string::npos) software = true;
    gl.GenVertexArrays(1, &no_attributes);
}

Renderer::Renderer(const GlProcLoader& get) : parts_(std::make_unique<Parts>(get)) {}

Renderer::~Renderer()
{
    parts_->gl.DeleteVertexArrays(1, &parts_->no_attributes);
}

const std::string& Renderer::driver() const
{
    return parts_->driver;
}
bool Renderer::is_software() const
{
    return parts_->software;
}
void Renderer::forget_context()
{
    // The names of our objects mean nothing in the next context, or something else: destructors delete nothing from here on.
    GlApi& gl = parts_->gl;
    gl.DeleteProgram = [](GLuint) {};
    const auto nothing = [](GLsizei, const GLuint*) {};
    gl.DeleteBuffers = nothing;
    gl.DeleteFramebuffers = nothing;
    gl.DeleteRenderbuffers = nothing;
    gl.DeleteVertexArrays = nothing;
}
void Renderer::finish()
{
    parts_->gl.Finish();
}
unsigned Renderer::error()
{
    return parts_->gl.GetError();
}
void Renderer::present(unsigned framebuffer)
{
    parts_->target.present(framebuffer);
}
Image Renderer::read_image()
{
    return parts_->target.read(parts_->shown_style.transparent_background);
}

void Renderer::draw(const DrawLists& lists, const Camera& camera, const Style& style, const Overlay& overlay, int samples)
{
    Parts& p = *parts_;
    const bool fresh = p.target.resize(camera.width(), camera.height(), samples);
    if (fresh || p.shown_version != lists.version() || p.shown_camera != camera || !(p.shown_style == style)) {
        p.target.draw_into_base();
        p.draw_base(lists, camera, style);
        p.shown_version = lists.version();
        p.shown_camera = camera;
        p.shown_style = style;
    }
    if (overlay == Overlay{} && lists.selected().empty() && lists.is_closed())
        p.target.draw_into_base();
    else {
        p.target.draw_into_top();
        p.draw_overlay(lists, camera, style, overlay);
    }
}

// --- the mesh ---------------------------------------------------------------------------------------------------------------

/// How much of the edges is seen: all of them from 3 pixels of mean length on, none below 1.5, where they would only darken.
double Renderer::Parts::edge_strength(const DrawLists& lists, const Camera& camera, const Style& style) const
{
    if (!style.fade_edges) return 1.0;
    constexpr double foreshortening = 0.785; // of a line in a random direction: pi / 4
    const double pixels = foreshortening * lists.mean_edge_length() / camera.unit_per_pixel();
    return std::clamp((pixels - 1.5) / 1.5, 0.0, 1.0);
}

void Renderer::Parts::draw_base(const DrawLists& lists, const Camera& camera, const Style& style)
{
    scene = lists.with_copies(lists.reach());
    const glm::dmat4 clip = camera.to_clip(lists.origin(), scene);
    to_clip = glm::mat4(clip);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LEQUAL);
    gl.DepthMask(GL_TRUE);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl.ProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw_background(style);
    if (lists.bounds().empty()) return;

    const bool with_faces = lists.has_faces() && !style.wireframe;
    strength = style.edges || !with_faces ? edge_strength(lists, camera, style) : 0.0;
    // By the shader a line is cut where triangles are smaller than it is wide, as those of a divided face are.
    const bool as_lines = !with_faces || style.see_through || lists.is_divided() || style.edge_method == Style::EdgeMethod::lines ||
                          (style.edge_method == Style::EdgeMethod::automatic && !software);
    variant = 0;
    if (style.shading == Style::Shading::smooth || lists.is_divided()) variant |= Variant::smooth;
    if (strength > 0 && !as_lines) variant |= Variant::edges;
    if (style.back_faces || style.see_through || !lists.is_closed()) variant |= Variant::both_sides;
    mesh.follow(lists, (variant & Variant::edges) != 0, (variant & Variant::smooth) != 0);

    under_lines = with_faces && strength > 0 && as_lines;
    if (with_faces) {
        use_faces(camera, style);
        draw_faces(style);
        for (const DrawLists::Copy& copy : lists.copies()) {
            const glm::mat4 there = placed(clip, lists.origin(), copy);
            const std::array<float, 3> colour = floats(copy.colour);
            gl.UniformMatrix4fv(face_program(variant).uniform("to_clip"), 1, GL_FALSE, glm::value_ptr(there));
            gl.Uniform4f(face_program(variant).uniform("paint"), colour[0], colour[1], colour[2], 1.0f);
            gl.Uniform1f(face_program(variant).uniform("edge_strength"), 0.0f);
            draw_faces(style);
        }
        gl.Disable(GL_POLYGON_OFFSET_FILL);
        if (under_lines) draw_lines(to_clip, style.edge, strength);
    } else {
        // Nothing lies under the lines but the background: they are light on a dark one, and do not vanish however short.
        const Colour colour = is_bright(style) ? style.edge : Colour{0xc8, 0xcc, 0xd4};
        const double opacity = std::max(strength, 0.25);
        draw_lines(to_clip, colour, opacity);
        for (const DrawLists::Copy& copy : lists.copies()) draw_lines(placed(clip, lists.origin(), copy), colour, opacity);
    }
}

void Renderer::Parts::draw_background(const Style& style)
{
    const std::array<float, 3> top = floats(style.background_top), bottom = floats(style.background_bottom);
    const float opacity = style.transparent_background ? 0.0f : 1.0f;
    gl.ClearDepth(1.0);
    gl.ClearColor(opacity * top[0], opacity * top[1], opacity * top[2], opacity);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (style.transparent_background || style.background_top == style.background_bottom) return;
    if (!background) background.emplace(gl, "", background_vertex_source, background_fragment_source);
    background->use();
    gl.Uniform3f(background->uniform("top"), top[0], top[1], top[2]);
    gl.Uniform3f(background->uniform("bottom"), bottom[0], bottom[1], bottom[2]);
    gl.Disable(GL_CULL_FACE);
    gl.Disable(GL_DEPTH_TEST);
    gl.BindVertexArray(no_attributes);
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.Enable(GL_DEPTH_TEST);
}

const Program& Renderer::Parts::face_program(unsigned which)
{
    std::optional<Program>& program = faces[which];
    if (!program) {
        std::string defines;
        if (which & Variant::smooth) defines += "#define SMOOTH\n";
        if (which & Variant::edges) defines += "#define EDGES\n";
        if (which & Variant::both_sides) defines += "#define BOTH_SIDES\n";
        program.emplace(gl, defines + light_source, faces_vertex_source, faces_fragment_source);
    }
    return *program;
}

const Program& Renderer::Parts::line_program()
{
    if (!lines) lines.emplace(gl, "", lines_vertex_source, lines_fragment_source);
    return *lines;
}

/// Sets the face shader up as the base needs it; what is drawn with it again falls on the same pixels.
void Renderer::Parts::use_faces(const Camera& camera, const Style& style)
{
    const Program& program = face_program(variant);
    program.use();
    const glm::mat3 to_eye(camera.rotation());
    const std::array<float, 3> selected = floats(style.selected), edge = floats(style.edge);
    gl.UniformMatrix4fv(program.uniform("to_clip"), 1, GL_FALSE, glm::value_ptr(to_clip));
    gl.UniformMatrix3fv(program.uniform("to_eye"), 1, GL_FALSE, glm::value_ptr(to_eye));
    gl.Uniform3f(program.uniform("selected_colour"), selected[0], selected[1], selected[2]);
    gl.Uniform4f(program.uniform("paint"), 0.0f, 0.0f, 0.0f, 0.0f);
    gl.Uniform2f(program.uniform("half_size"), 0.5f * float(camera.width()), 0.5f * float(camera.height()));
    gl.Uniform3f(program.uniform("edge_colour"), edge[0], edge[1], edge[2]);
    gl.Uniform1f(program.uniform("edge_strength"), float(strength));
    gl.Uniform1f(program.uniform("edge_half_width"), float(edge_half_width * style.line_scale));
    gl.Uniform1f(program.uniform("opacity"), style.see_through ? 0.4f : 1.0f);
    if (under_lines) gl.Enable(GL_POLYGON_OFFSET_FILL);
    gl.PolygonOffset(1.0f, 1.0f);
    gl.CullFace(GL_BACK);
    if (variant & Variant::both_sides)
        gl.Disable(GL_CULL_FACE);
    else
        gl.Enable(GL_CULL_FACE);
}

void Renderer::Parts::draw_faces(const Style& style)
{
    if (!style.see_through) {
        mesh.draw_triangles();
        return;
    }
    // Far sides first; within each pass the order does not matter much at this opacity, and nothing is sorted.
    gl.Enable(GL_BLEND);
    gl.DepthMask(GL_FALSE);
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(GL_FRONT);
    mesh.draw_triangles();
    gl.CullFace(GL_BACK);
    mesh.draw_triangles();
    gl.DepthMask(GL_TRUE);
    gl.Disable(GL_BLEND);
}

/// Once more, in another colour, over what the base shows of these faces: nothing else is that far from the eye.
void Renderer::Parts::draw_painted(const DrawLists& lists, const Camera& camera, const Style& style, const Overlay& overlay)
{
    use_faces(camera, style);
    const std::array<float, 3> paint = floats(overlay.paint);
    gl.Uniform4f(face_program(variant).uniform("paint"), paint[0], paint[1], paint[2], 1.0f);
    if (style.see_through) gl.Enable(GL_BLEND);
    gl.DepthMask(GL_FALSE);
    mesh.draw_faces(lists, overlay.painted);
    gl.DepthMask(GL_TRUE);
    gl.Disable(GL_BLEND);
    gl.Disable(GL_POLYGON_OFFSET_FILL);
}

void Renderer::Parts::draw_lines(const glm::mat4& to, Colour colour, double opacity)
{
    const Program& program = line_program();
    program.use();
    const std::array<float, 3> c = floats(colour);
    gl.UniformMatrix4fv(program.uniform("to_clip"), 1, GL_FALSE, glm::value_ptr(to));
    gl.Uniform4f(program.uniform("colour"), c[0], c[1], c[2], float(opacity));
    gl.Enable(GL_BLEND);
    mesh.draw_edges();
    gl.Disable(GL_BLEND);
}

// --- what goes over it ------------------------------------------------------------------------------------------------------

void Renderer::Parts::draw_overlay(const DrawLists& lists, const Camera& camera, const Style& style, const Overlay& overlay)
{
    const double scale = style.line_scale;
    const auto alive = [&](const std::array<std::uint32_t, 2>& pair) {
        return pair[0] < lists.vertex_limit() && pair[1] < lists.vertex_limit();
    };
    const auto outline = [&](std::vector<ThickLine>& to, const auto& chosen, Colour colour, double width) {
        const std::size_t begun = to.size();
        for (const Face f : chosen) {
            for (const auto& [a, b] : lists.sides(f))
                to.push_back({lists.position(a), lists.position(b), colour, width * scale, 1});
            if (to.size() - begun > most_outlined) {
                to.resize(begun);
                return;
            }
        }
    };

    if (!style.wireframe && !overlay.painted.empty()) draw_painted(lists, camera, style, overlay);

    // Tints: the faces drawn once more, a little nearer.
    if (!style.wireframe && !(overlay.hovered.empty() && overlay.pressed.empty() && overlay.failed.empty())) {
        const Program& program = line_program();
        program.use();
        gl.UniformMatrix4fv(program.uniform("to_clip"), 1, GL_FALSE, glm::value_ptr(to_clip));
        gl.Disable(GL_CULL_FACE);
        gl.Enable(GL_BLEND);
        gl.DepthMask(GL_FALSE);
        gl.Enable(GL_POLYGON_OFFSET_FILL);
        gl.PolygonOffset(-1.0f, -2.0f);
        const auto tint = [&](const std::vector<Face>& chosen, Colour colour, float opacity) {
            const std::array<float, 3> c = floats(colour);
            gl.Uniform4f(program.uniform("colour"), c[0], c[1], c[2], opacity);
            mesh.draw_faces(lists, chosen);
        };
        if (overlay.painted.empty()) { // or it would not be seen what colour they get
            tint(overlay.hovered, overlay.highlight, 0.10f);
            tint(overlay.pressed, overlay.highlight, 0.22f);
        }
        tint(overlay.failed, overlay.error, 0.30f);
        gl.Disable(GL_POLYGON_OFFSET_FILL);
        gl.DepthMask(GL_TRUE);
        gl.Disable(GL_BLEND);
    }

    std::vector<ThickLine> seen, over;
    if ((style.edges || style.wireframe) && lists.boundary_sides().size() <= most_outlined)
        for (const auto& pair : lists.boundary_sides())
            if (alive(pair)) seen.push_back({lists.position(pair[0]), lists.position(pair[1]), style.boundary, 2 * scale, 1});
    outline(seen, lists.selected(), style.selected, 2);
    for (const Edge e : overlay.edges)
        if (e.index < lists.edge_limit() && alive(lists.edges()[e.index])) {
            const auto& [a, b] = lists.edges()[e.index];
            seen.push_back({lists.position(a), lists.position(b), overlay.highlight, 3 * scale, 1});
        }
    for (const Vertex v : overlay.vertices)
        if (v.index < lists.vertex_limit())
            seen.push_back({lists.position(v.index), lists.position(v.index), overlay.highlight, 7 * scale, 1});
    outline(over, overlay.hovered, overlay.highlight, 1.5);
    outline(over, overlay.pressed, overlay.highlight, 3);
    outline(over, overlay.failed, overlay.error, 3);
    over.insert(over.end(), overlay.lines.begin(), overlay.lines.end());

    std::optional<double> shift;
    if (!style.wireframe && !style.see_through) shift = camera.depth_shift(4 * scale, scene);
    thick.draw(seen, lists.origin(), to_clip, camera.width(), camera.height(), shift);
    thick.draw(over, lists.origin(), to_clip, camera.width(), camera.height(), std::nullopt);

    if (overlay.screen_lines.empty()) return;
    glm::mat4 from_pixels(1.0f);
    from_pixels[0][0] = 2.0f / float(camera.width());
    from_pixels[1][1] = -2.0f / float(camera.height());
    from_pixels[2][2] = 0.0f;
    from_pixels[3] = glm::vec4(-1.0f, 1.0f, 0.0f, 1.0f);
    thick.draw(overlay.screen_lines, Point(0.0), from_pixels, camera.width(), camera.height(), std::nullopt);
}

} // namespace druse
