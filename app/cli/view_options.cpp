#include <algorithm>

#include "app/cli/options.h"
#include "app/cli/words.h"
#include "core/io/read_file.h"

namespace zscope::cli {
namespace {}  // namespace

void ViewOptions::add(CLI::App& parser)
{
    const auto option = [&](const char* name, std::optional<std::string>& value, const char* type, const char* help) {
        parser.add_option(name, value, help)->type_name(type)->group("View");
    };
    option("--size", m_size, "WxH", "Size of the picture in pixels (default 1280x720)");
    option("--eye", m_eye, "X,Y,Z", "Where the eye is (default: far enough to see the whole scene)");
    option("--target", m_target, "X,Y,Z", "What the eye looks at (default: the middle of the scene)");
    option("--up", m_up, "X,Y,Z", "Which way is up (default 0,1,0)");
    option("--fov", m_fov, "DEGREES", "Vertical field of view (default 45)");
    option("--near", m_near, "N", "Distance of the near plane (default: from the scene's bounds)");
    option("--far", m_far, "F", "Distance of the far plane, or inf (default: from the scene's bounds)");
    option("--cull", m_cull, "none|back", "Faces that are not drawn (default none)");
    option("--camera", m_camera, "FILE", "All ten numbers of the camera from a JSON file; only --cull may be added");
}

Result<ViewWords> ViewOptions::read() const
{
    ViewWords  words;
    const auto given = [&words](const std::optional<std::string>& value, const char* option) {
        if (value) words.given.emplace_back(option);
    };
    given(m_size, "--size");
    given(m_eye, "--eye");
    given(m_target, "--target");
    given(m_up, "--up");
    given(m_fov, "--fov");
    given(m_near, "--near");
    given(m_far, "--far");
    if (m_cull) {
        if (*m_cull != "none" && *m_cull != "back") return unknownWord("choice of --cull", *m_cull, {"none", "back"});
        words.faceCulling = *m_cull == "back" ? FaceCulling::Back : FaceCulling::None;
    }
    return m_camera ? readCamera(std::move(words)) : readParts(std::move(words));
}

Result<ViewWords> ViewOptions::readCamera(ViewWords words) const
{
    if (!words.given.empty())
        return Error{Trouble::Usage, "--camera sets all ten numbers and cannot be mixed with " + words.given.front()};
    const Result<std::string> text = readRegularFile(*m_camera, kMaxCameraFile);
    if (!text) return text.error();
    const Result<Camera> camera = cameraFromJson(*text, *m_camera);
    if (!camera) return camera.error();
    words.request.exact = *camera;
    words.given.emplace_back("--camera");
    return words;
}

Result<ViewWords> ViewOptions::readParts(ViewWords words) const
{
    ViewRequest& request = words.request;
    if (m_size) {
        const auto size = pictureSize(*m_size, "--size");
        if (!size) return size.error();
        request.width  = size->width;
        request.height = size->height;
    }
    const auto place = [](const std::optional<std::string>& text, const char* option, auto& into) -> Result<Done> {
        if (!text) return Done{};
        const Result<dvec3> v = vector(*text, option);
        if (!v) return v.error();
        into = *v;
        return Done{};
    };
    const auto number = [](const std::optional<std::string>& text, const char* option, Infinity infinity,
                           auto& into) -> Result<Done> {
        if (!text) return Done{};
        const Result<double> value = realNumber(*text, option, infinity);
        if (!value) return value.error();
        into = *value;
        return Done{};
    };
    for (const Result<Done>& done :
         {place(m_eye, "--eye", request.eye), place(m_target, "--target", request.target),
          place(m_up, "--up", request.up), number(m_fov, "--fov", Infinity::Refused, request.verticalFov),
          number(m_near, "--near", Infinity::Refused, request.near),
          number(m_far, "--far", Infinity::Allowed, request.far)})
        if (!done) return done.error();

    // What can be refused without a scene is refused before one is loaded: any box will do.
    Bounds anyBox;
    anyBox.include({-1, -1, -1});
    anyBox.include({1, 1, 1});
    ViewRequest sizeAndAngle;
    sizeAndAngle.width       = request.width;
    sizeAndAngle.height      = request.height;
    sizeAndAngle.verticalFov = request.verticalFov;
    if (const Result<Camera> possible = makeCamera(sizeAndAngle, anyBox); !possible) return possible.error();
    return words;
}

ViewRequest ViewWords::requestFor(const Scene& scene, std::string_view viewName) const
{
    ViewRequest view;
    const auto  named = std::ranges::find(scene.views, viewName, &NamedView::name);
    if (named != scene.views.end())
        view = named->view;
    else if (!scene.views.empty())
        view = scene.views.front().view;
    // A view said in parts does not mix with ten numbers: it replaces them.
    if (!given.empty() && (view.exact || request.exact)) {
        const std::optional<FaceCulling> sceneCulling = view.faceCulling;
        view                                          = {};
        view.faceCulling                              = sceneCulling;
    }
    for (const std::string& option : given) {
        if (option == "--camera") view.exact = request.exact;
        if (option == "--size") {
            view.width  = request.width;
            view.height = request.height;
        }
        if (option == "--eye") view.eye = request.eye;
        if (option == "--target") view.target = request.target;
        if (option == "--up") view.up = request.up;
        if (option == "--fov") view.verticalFov = request.verticalFov;
        if (option == "--near") view.near = request.near;
        if (option == "--far") view.far = request.far;
    }
    if (faceCulling) view.faceCulling = faceCulling;
    return view;
}

Result<ViewWords::View> ViewWords::of(const Scene& scene, std::string_view viewName) const
{
    const ViewRequest    view   = requestFor(scene, viewName);
    const Result<Camera> camera = makeCamera(view, scene.bounds);
    if (!camera) return camera.error();
    return View{*camera, view.faceCulling.value_or(FaceCulling::None)};
}

}  // namespace zscope::cli
