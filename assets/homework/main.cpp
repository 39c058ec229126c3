// homework SCENE.obj CAMERA.json FOLDER [zbuffer|scanline|hierarchical] [--cull]
#include <iostream>
#include <map>
#include <string>

#include "methods.h"

int main(int count, char** words)
{
    const std::map<std::string, Method> methods{
        {"zbuffer", Method::ZBuffer}, {"scanline", Method::Scanline}, {"hierarchical", Method::Hierarchical}};
    const auto method = methods.find(count > 4 ? words[4] : "zbuffer");
    const bool cull   = count > 5 && std::string(words[5]) == "--cull";
    if (count < 4 || count > 6 || (count == 6 && !cull) || method == methods.end()) {
        std::cerr << "usage: homework SCENE.obj CAMERA.json FOLDER [zbuffer|scanline|hierarchical] [--cull]\n";
        return 2;
    }
    const Scene  scene     = readObj(words[1]);
    const Camera camera    = readCamera(words[2]);
    const auto   triangles = toScreen(scene, camera, cull ? Cull::BackFaces : Cull::None);
    Picture      picture(camera);
    draw(method->second, triangles, picture);
    write(picture, words[3]);
    return 0;
}
