/* zscope_dump.h: writes what your renderer drew into one file, with one call, for `zscope-cli check --dump FILE`.
 *
 *     #include "zscope_dump.h"
 *     ...
 *     zscope_dump("out.zdump", width, height, depth, ids, 0, 0, ZSCOPE_TOP_DOWN);
 *
 * Depth       width * height floats, row after row, in any convention (1 / z, z, 0 to 1, ...); 0: no depths
 * Ids         width * height ints, row after row: which triangle each pixel shows, -1 for background; 0: no ids
 * Matrices    16 doubles each, view (world to eye) and projection (eye to clip space); 0: no matrix
 * Convention  flags from the list below, joined by |; ZScope finds out what is not said
 * Answer      0: the file is complete. 1: an argument is wrong. 2: the file cannot be written, and is not there
 *
 * One file, nothing to build, no dependency but the C library. C99, C++98 and every later C and C++; 32-bit int,
 * 32-bit float and 64-bit double.
 *
 * File        8 bytes "ZSDUMP1" and a line feed; nine 32-bit numbers: 0x01020304, width, height, contents (1 depth +
 *             2 ids + 4 view + 8 projection), rows, order of the matrices, depth range, ids from, 0; then view,
 *             projection, depth and ids, as far as they are there. All of it in the writing machine's byte order
 *
 * MIT License
 *
 * Copyright (c) 2026 The ZScope authors
 *
 * Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
 * documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
 * rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to
 * permit persons to whom the Software is furnished to do so, subject to the following conditions:
 *
 * The above copyright notice and this permission notice shall be included in all copies or substantial portions of
 * the Software.
 *
 * THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO
 * THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
 * AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT,
 * TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
 * SOFTWARE.
 */
#ifndef ZSCOPE_DUMP_H
#define ZSCOPE_DUMP_H

#include <stddef.h>
#include <stdio.h>

/* Which row of the arrays comes first. */
#define ZSCOPE_TOP_DOWN 1u
#define ZSCOPE_BOTTOM_UP 2u
/* Which numbers of a matrix are neighbours in memory: those of a row, or those of a column (as in OpenGL and GLM). */
#define ZSCOPE_MATRIX_ROWS 4u
#define ZSCOPE_MATRIX_COLUMNS 8u
/* What the projection makes of near and far: -1 and 1 (OpenGL), 0 and 1 (Direct3D, Vulkan), 1 and 0 (reversed). */
#define ZSCOPE_DEPTH_MINUS_1_TO_1 16u
#define ZSCOPE_DEPTH_0_TO_1 32u
#define ZSCOPE_DEPTH_REVERSED 48u
/* The id of the first triangle. */
#define ZSCOPE_IDS_FROM_0 64u
#define ZSCOPE_IDS_FROM_1 128u

#define ZSCOPE_LARGEST_SIDE 16384 /* pixels; the largest picture that ZScope reads */

#if defined(_MSC_VER) && !defined(__cplusplus)
#define ZSCOPE_DUMP_FUNCTION static __inline
#else
#define ZSCOPE_DUMP_FUNCTION static inline
#endif

#ifdef _MSC_VER
#pragma warning(push)
#pragma warning(disable : 4996) /* Visual Studio would have fopen_s, which other compilers do not have */
#endif

/* Does not compile where these types have other sizes. */
typedef char zscope_dump_needs_these_sizes[sizeof(int) == 4 && sizeof(float) == 4 && sizeof(double) == 8 ? 1 : -1];

/* 1: all of it was written. */
ZSCOPE_DUMP_FUNCTION int zscope_dump_put(FILE* file, const void* data, size_t size, size_t count)
{
    return !data || fwrite(data, size, count, file) == count;
}

ZSCOPE_DUMP_FUNCTION int zscope_dump(const char* path, int width, int height, const float* depth, const int* ids,
                                     const double* view, const double* projection, unsigned int convention)
{
    unsigned int header[9];
    size_t       pixels;
    FILE*        file;
    int          complete;

    if (!path || width < 1 || height < 1 || width > ZSCOPE_LARGEST_SIDE || height > ZSCOPE_LARGEST_SIDE) return 1;
    if ((!depth && !ids) || convention > 255u) return 1;
    if ((convention & 3u) == 3u || (convention & 12u) == 12u || (convention & 192u) == 192u) return 1;

    header[0] = 0x01020304u;
    header[1] = (unsigned int)width;
    header[2] = (unsigned int)height;
    header[3] = (depth ? 1u : 0u) | (ids ? 2u : 0u) | (view ? 4u : 0u) | (projection ? 8u : 0u);
    header[4] = convention & 3u;
    header[5] = (convention >> 2) & 3u;
    header[6] = (convention >> 4) & 3u;
    header[7] = (convention >> 6) & 3u;
    header[8] = 0u;
    pixels    = (size_t)width * (size_t)height;

    file = fopen(path, "wb");
    if (!file) return 2;
    complete =
        zscope_dump_put(file, "ZSDUMP1\n", 1, 8) && zscope_dump_put(file, header, sizeof header[0], 9)
        && zscope_dump_put(file, view, sizeof(double), 16) && zscope_dump_put(file, projection, sizeof(double), 16)
        && zscope_dump_put(file, depth, sizeof(float), pixels) && zscope_dump_put(file, ids, sizeof(int), pixels);
    if (fclose(file) != 0) complete = 0;
    if (!complete) remove(path);
    return complete ? 0 : 2;
}

#ifdef _MSC_VER
#pragma warning(pop)
#endif

#endif
