#include "scene.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

void stop(const std::string& file, int line, const std::string& sentence)
{
    std::cerr << file << ':';
    if (line > 0) std::cerr << line << ':';
    std::cerr << ' ' << sentence << '\n';
    std::exit(3);
}

namespace {

struct Vec2 {
    double x, y;
};

/// Twice the area of a triangle; above 0: a, b, c turn left.
double turn(Vec2 a, Vec2 b, Vec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// The face in the plane of two axes in which it is largest, turning left.
std::vector<Vec2> flat(const std::vector<Vec3>& vertices, const std::vector<int>& face)
{
    Vec3 normal;  // Newell's
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3 a = vertices[std::size_t(face[i])], b = vertices[std::size_t(face[(i + 1) % face.size()])];
        normal.x += (a.y - b.y) * (a.z + b.z);
        normal.y += (a.z - b.z) * (a.x + b.x);
        normal.z += (a.x - b.x) * (a.y + b.y);
    }
    const double      x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
    std::vector<Vec2> points;
    for (const int corner : face) {
        const Vec3 p = vertices[std::size_t(corner)];
        if (x >= y && x >= z)
            points.push_back(normal.x > 0 ? Vec2{p.y, p.z} : Vec2{p.z, p.y});
        else if (y >= z)
            points.push_back(normal.y > 0 ? Vec2{p.z, p.x} : Vec2{p.x, p.z});
        else
            points.push_back(normal.z > 0 ? Vec2{p.x, p.y} : Vec2{p.y, p.x});
    }
    return points;
}

bool isConvex(const std::vector<Vec2>& points)
{
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i)
        if (turn(points[i], points[(i + 1) % n], points[(i + 2) % n]) < 0) return false;
    return true;
}

void fan(const std::vector<int>& face, std::vector<std::array<int, 3>>& triangles)
{
    for (std::size_t i = 2; i < face.size(); ++i) triangles.push_back({face[0], face[i - 1], face[i]});
}

/// A corner is an ear if it turns left and no other corner lies in its triangle.
bool isEar(const std::vector<Vec2>& points, std::size_t at)
{
    const std::size_t n      = points.size();
    const std::size_t before = (at + n - 1) % n, after = (at + 1) % n;
    const Vec2        a = points[before], b = points[at], c = points[after];
    if (turn(a, b, c) <= 0) return false;
    for (std::size_t i = 0; i < n; ++i) {
        if (i == before || i == at || i == after) continue;
        if (turn(a, b, points[i]) >= 0 && turn(b, c, points[i]) >= 0 && turn(c, a, points[i]) >= 0) return false;
    }
    return true;
}

void cutEars(std::vector<int> face, std::vector<Vec2> points, std::vector<std::array<int, 3>>& triangles)
{
    while (face.size() > 3) {
        std::size_t ear = 0;
        while (ear < face.size() && !isEar(points, ear)) ++ear;
        if (ear == face.size()) break;  // the outline crosses itself
        const std::size_t n = face.size();
        triangles.push_back({face[(ear + n - 1) % n], face[ear], face[(ear + 1) % n]});
        face.erase(face.begin() + std::ptrdiff_t(ear));
        points.erase(points.begin() + std::ptrdiff_t(ear));
    }
    fan(face, triangles);
}

void split(Scene& scene, const std::vector<int>& face)
{
    if (face.size() == 3) return fan(face, scene.triangles);
    const std::vector<Vec2> points = flat(scene.vertices, face);
    if (isConvex(points)) return fan(face, scene.triangles);
    cutEars(face, points, scene.triangles);
}

}  // namespace

Scene readObj(const std::string& file)
{
    std::ifstream stream(file);
    if (!stream) stop(file, 0, "cannot be read");
    Scene scene;
    int   lineNumber = 0;
    for (std::string line; std::getline(stream, line);) {
        ++lineNumber;
        std::istringstream words(line);
        std::string        word;
        words >> word;
        if (word == "v") {
            std::string x, y, z;
            if (!(words >> x >> y >> z)) stop(file, lineNumber, "a vertex needs three numbers");
            scene.vertices.push_back(
                {std::strtod(x.c_str(), nullptr), std::strtod(y.c_str(), nullptr), std::strtod(z.c_str(), nullptr)});
        } else if (word == "f") {
            std::vector<int> face;
            while (words >> word && word[0] != '#') {
                const int given = std::atoi(word.c_str());  // stops at '/'
                const int count = int(scene.vertices.size());
                const int index = given > 0 ? given - 1 : count + given;
                if (given == 0 || index < 0 || index >= count)
                    stop(file, lineNumber, "there is no vertex '" + word + "'");
                face.push_back(index);
            }
            if (face.size() < 3) stop(file, lineNumber, "a face needs three corners");
            split(scene, face);
        }
    }
    return scene;
}
