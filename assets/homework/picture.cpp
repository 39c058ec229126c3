#include "picture.h"

#include <fstream>
#include <iostream>
#include <set>

#include "zscope_dump.h"

Picture::Picture(const Camera& camera)
    : width(camera.width), height(camera.height), far(float(camera.near / camera.far)),
      depth(std::size_t(camera.width) * std::size_t(camera.height), 0.0f), ids(depth.size(), -1)
{}

namespace {

/// A colour for each triangle; neighbours differ.
void appendColour(std::string& bytes, int id)
{
    const unsigned mixed = id < 0 ? 0 : (unsigned(id) + 1) * 2654435761u;
    for (const unsigned shift : {24u, 16u, 8u}) bytes += char(id < 0 ? 0 : 64 + ((mixed >> shift) & 127));
}

}  // namespace

void write(const Picture& picture, const std::string& folder)
{
    const std::string dump = folder + "/out.zdump";
    if (zscope_dump(dump.c_str(), picture.width, picture.height, picture.depth.data(), picture.ids.data(), nullptr,
                    nullptr, ZSCOPE_TOP_DOWN | ZSCOPE_IDS_FROM_0)
        != 0)
        stop(dump, 0, "cannot be written: does the folder exist?");

    std::string bytes = "P6\n" + std::to_string(picture.width) + ' ' + std::to_string(picture.height) + "\n255\n";
    for (const int id : picture.ids) appendColour(bytes, id);
    const std::string ppm = folder + "/picture.ppm";
    std::ofstream     file(ppm, std::ios::binary);
    if (!file.write(bytes.data(), std::streamsize(bytes.size())).flush()) stop(ppm, 0, "cannot be written");
}

void stillEmpty(const char* file, const char* function)
{
    static std::set<std::string> said;
    std::string                  name = file;
    name.erase(0, name.find_last_of("/\\") + 1);
    if (said.insert(name + function).second) std::cerr << name << ": " << function << "() is still empty\n";
}
