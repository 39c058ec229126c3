#include "camera.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace {

/// The numbers behind `"key":`, one or `count` in brackets. A number may stand in quotes: "0x1.8p+1", "inf".
void numbersOf(const std::string& text, const std::string& file, const std::string& key, int count, double* numbers)
{
    std::size_t at = text.find('"' + key + '"');
    if (at == std::string::npos) stop(file, 0, "there is no \"" + key + '"');
    at = text.find(':', at);
    for (int i = 0; i < count; ++i) {
        at = at == std::string::npos ? at : text.find_first_not_of(": \t\r\n[,\"", at);
        if (at == std::string::npos) stop(file, 0, "the file ends in \"" + key + '"');
        const char* begin = text.c_str() + at;
        char*       end   = nullptr;
        numbers[i]        = std::strtod(begin, &end);
        if (end == begin) stop(file, 0, '"' + key + "\" needs " + std::to_string(count) + " numbers");
        at = text.find_first_not_of('"', at + std::size_t(end - begin));
    }
}

}  // namespace

Camera readCamera(const std::string& file)
{
    std::ifstream stream(file);
    if (!stream) stop(file, 0, "cannot be read");
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};

    const auto number = [&](const char* key) {
        double value = 0;
        numbersOf(text, file, key, 1, &value);
        return value;
    };
    const auto vector = [&](const char* key) {
        double values[3];
        numbersOf(text, file, key, 3, values);
        return Vec3{values[0], values[1], values[2]};
    };
    Camera camera;
    camera.eye     = vector("eye");
    camera.right   = vector("right");
    camera.up      = vector("up");
    camera.forward = vector("forward");
    camera.focal   = number("focal");
    camera.near    = number("near");
    camera.far     = number("far");
    camera.width   = int(number("width"));
    camera.height  = int(number("height"));
    if (camera.width < 1 || camera.height < 1 || camera.width > 16384 || camera.height > 16384)
        stop(file, 0, "a picture has 1 to 16384 pixels a side");
    return camera;
}
