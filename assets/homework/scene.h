// A scene of triangles, read from an OBJ file.
//
// Reads      "v" and "f"; corners of a face as 7, 7/1, 7//3, 7/1/3 or -1 (counted from the end), nothing else
// Polygons   a convex face becomes a fan from its first corner; from a concave face, ears are cut off
// Id         a triangle's place in `triangles`, counted from 0
#pragma once

#include <array>
#include <string>
#include <vector>

struct Vec3 {
    double x = 0, y = 0, z = 0;
};

struct Scene {
    std::vector<Vec3>               vertices;
    std::vector<std::array<int, 3>> triangles;  // indices of vertices
};

/// Ends the program with a sentence if the file cannot be read.
Scene readObj(const std::string& file);

/// Prints "file:line: sentence" and ends the program; line 0: no line.
[[noreturn]] void stop(const std::string& file, int line, const std::string& sentence);
