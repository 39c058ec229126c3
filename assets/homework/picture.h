// What the methods draw into, and what is written at the end: out.zdump for "zscope-cli check", picture.ppm to look at.
#pragma once

#include <string>
#include <vector>

#include "camera.h"

struct Picture {
    explicit Picture(const Camera& camera);

    int                width, height;
    float              far;    // depth of the far plane; what is smaller is not seen
    std::vector<float> depth;  // near / z, larger is nearer; 0 is background. Top line first
    std::vector<int>   ids;    // -1 is background

    std::size_t at(int i, int j) const { return std::size_t(j) * std::size_t(width) + std::size_t(i); }
};

/// Writes out.zdump and picture.ppm. Ends the program with a sentence if that fails.
void write(const Picture& picture, const std::string& folder);

/// Says once that a function is still a gap.
void stillEmpty(const char* file, const char* function);
