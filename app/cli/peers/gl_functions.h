// The few functions of OpenGL and OSMesa that the comparison with llvmpipe calls, looked up when it runs, so that the
// program neither needs the library nor spends the time to load it where nobody compares.
#pragma once

#include <memory>
#include <optional>

#define GL_GLEXT_PROTOTYPES 1
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <dlfcn.h>

namespace zscope::cli {

#define ZSCOPE_GL_FUNCTIONS(f)                                                                                         \
    f(OSMesaCreateContextExt) f(OSMesaMakeCurrent) f(OSMesaDestroyContext) f(glGetString) f(glGetError) f(glFinish)    \
        f(glClear) f(glEnable) f(glCullFace) f(glShadeModel) f(glViewport) f(glMatrixMode) f(glLoadIdentity)           \
            f(glLoadMatrixd) f(glGenBuffers) f(glBindBuffer) f(glBufferData) f(glEnableClientState) f(glVertexPointer) \
                f(glColorPointer) f(glDrawElements) f(glReadPixels) f(glPixelStorei) f(glGenFramebuffers)              \
                    f(glBindFramebuffer) f(glGenRenderbuffers) f(glBindRenderbuffer) f(glRenderbufferStorage)          \
                        f(glFramebufferRenderbuffer) f(glCheckFramebufferStatus)

/// Every function under its own name. The library stays loaded as long as the process lives.
struct GlFunctions {
#define ZSCOPE_DECLARE(name) decltype(&::name) name = nullptr;
    ZSCOPE_GL_FUNCTIONS(ZSCOPE_DECLARE)
#undef ZSCOPE_DECLARE

    /// Nothing if the library or one of the functions is not there.
    static std::optional<GlFunctions> load()
    {
        void* library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
        if (!library) return std::nullopt;
        GlFunctions gl;
        bool        all = true;
#define ZSCOPE_LOOK_UP(function)                                                      \
    gl.function = reinterpret_cast<decltype(gl.function)>(dlsym(library, #function)); \
    all         = all && gl.function != nullptr;
        ZSCOPE_GL_FUNCTIONS(ZSCOPE_LOOK_UP)
#undef ZSCOPE_LOOK_UP
        return all ? std::optional(gl) : std::nullopt;
    }
};

}  // namespace zscope::cli
