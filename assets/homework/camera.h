// The camera, as "zscope-cli render SCENE --print-camera > camera.json" writes it.
#pragma once

#include <string>

#include "scene.h"

struct Camera {
    Vec3   eye, right, up, forward;    // the axes have length 1
    double focal = 1;                  // 1 / tan(vertical field of view / 2)
    double near = 0.1, far = 1e6;      // distances along `forward`; far may be infinite
    int    width = 640, height = 480;  // pixels
};

/// Ends the program with a sentence if the file cannot be read.
Camera readCamera(const std::string& file);
