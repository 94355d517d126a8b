#pragma once

#include "render/gl_proc.h"

// GL headers clash with each other, so this is the only place that includes one; nothing outside this room includes this file.
#include <GL/glcorearb.h>

namespace druse {

// clang-format off
#define DRUSE_GL_FUNCTIONS(X)                                       \
    X(PFNGLATTACHSHADERPROC, AttachShader)                          \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                              \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                    \
    X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)                  \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                    \
    X(PFNGLBLENDFUNCSEPARATEPROC, BlendFuncSeparate)                \
    X(PFNGLBLITFRAMEBUFFERPROC, BlitFramebuffer)                    \
    X(PFNGLBUFFERDATAPROC, BufferData)                              \
    X(PFNGLBUFFERSUBDATAPROC, BufferSubData)                        \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)      \
    X(PFNGLCLEARPROC, Clear)                                        \
    X(PFNGLCLEARCOLORPROC, ClearColor)                              \
    X(PFNGLCLEARDEPTHPROC, ClearDepth)                              \
    X(PFNGLCOLORMASKPROC, ColorMask)                                \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                        \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                        \
    X(PFNGLCREATESHADERPROC, CreateShader)                          \
    X(PFNGLCULLFACEPROC, CullFace)                                  \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                        \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)              \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                        \
    X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)            \
    X(PFNGLDELETESHADERPROC, DeleteShader)                          \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)              \
    X(PFNGLDEPTHFUNCPROC, DepthFunc)                                \
    X(PFNGLDEPTHMASKPROC, DepthMask)                                \
    X(PFNGLDISABLEPROC, Disable)                                    \
    X(PFNGLDISABLEVERTEXATTRIBARRAYPROC, DisableVertexAttribArray)  \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)                              \
    X(PFNGLDRAWARRAYSINSTANCEDPROC, DrawArraysInstanced)            \
    X(PFNGLDRAWELEMENTSPROC, DrawElements)                          \
    X(PFNGLENABLEPROC, Enable)                                      \
    X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)    \
    X(PFNGLFINISHPROC, Finish)                                      \
    X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer)    \
    X(PFNGLGENBUFFERSPROC, GenBuffers)                              \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                    \
    X(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)                  \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                    \
    X(PFNGLGETERRORPROC, GetError)                                  \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                            \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                          \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                  \
    X(PFNGLGETSHADERIVPROC, GetShaderiv)                            \
    X(PFNGLGETSTRINGPROC, GetString)                                \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)              \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                            \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                            \
    X(PFNGLPOLYGONOFFSETPROC, PolygonOffset)                        \
    X(PFNGLPROVOKINGVERTEXPROC, ProvokingVertex)                    \
    X(PFNGLREADBUFFERPROC, ReadBuffer)                              \
    X(PFNGLREADPIXELSPROC, ReadPixels)                              \
    X(PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC, RenderbufferStorageMultisample) \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                          \
    X(PFNGLUNIFORM1FPROC, Uniform1f)                                \
    X(PFNGLUNIFORM2FPROC, Uniform2f)                                \
    X(PFNGLUNIFORM3FPROC, Uniform3f)                                \
    X(PFNGLUNIFORM4FPROC, Uniform4f)                                \
    X(PFNGLUNIFORMMATRIX3FVPROC, UniformMatrix3fv)                  \
    X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv)                  \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                              \
    X(PFNGLVERTEXATTRIBDIVISORPROC, VertexAttribDivisor)            \
    X(PFNGLVERTEXATTRIBIPOINTERPROC, VertexAttribIPointer)          \
    X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)            \
    X(PFNGLVIEWPORTPROC, Viewport)
// clang-format on

/// The OpenGL functions Druse uses, as found in one context.
///
/// The ready-made loaders do not work on an OSMesa context (libepoxy aborts, GLEW says "Missing GL version"), and with two GL
/// libraries in a process a global `gl…` call may reach the wrong one: so every call goes through a table like this, and each
/// context has its own.
struct GlApi {
#define DRUSE_GL_MEMBER(type, name) type name = nullptr;
    DRUSE_GL_FUNCTIONS(DRUSE_GL_MEMBER)
#undef DRUSE_GL_MEMBER

    /// Fills the table from the context that is current.
    /// @throws SystemError naming the functions that are missing
    static GlApi load(const GlProcLoader& get);
};

} // namespace druse
