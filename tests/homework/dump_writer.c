/* Writes what dump_test.cpp expects, compiled as C and as C++: argv[1] is the file, argv[2] which of the dumps. */
#include "zscope_dump.h"

int main(int argc, char** argv)
{
    const float depth[6]       = {0.0f, 0.25f, 0.5f, 0.75f, 1.0f, 0.125f};
    const int   ids[6]         = {-1, 0, 1, 2, 70000, -1};
    double      view[16]       = {0};
    double      projection[16] = {0};
    int         i;

    if (argc != 3) return 9;
    for (i = 0; i < 16; ++i) view[i] = i + 0.5;
    for (i = 0; i < 16; ++i) projection[i] = -i / 3.0;

    switch (argv[2][0]) {
        case 'a':  /* all of it */
            return zscope_dump(argv[1], 3, 2, depth, ids, view, projection,
                               ZSCOPE_BOTTOM_UP | ZSCOPE_MATRIX_COLUMNS | ZSCOPE_DEPTH_REVERSED | ZSCOPE_IDS_FROM_1);
        case 'd': return zscope_dump(argv[1], 2, 3, depth, 0, 0, 0, ZSCOPE_TOP_DOWN);
        case 'i': return zscope_dump(argv[1], 6, 1, 0, ids, 0, projection, ZSCOPE_DEPTH_0_TO_1 | ZSCOPE_IDS_FROM_0);
        case 'n': return zscope_dump(argv[1], 3, 2, 0, 0, view, projection, 0);
        case 's': return zscope_dump(argv[1], 0, 2, depth, ids, 0, 0, 0);
        case 'l': return zscope_dump(argv[1], 16385, 1, depth, ids, 0, 0, 0);
        case 'c': return zscope_dump(argv[1], 3, 2, depth, ids, 0, 0, ZSCOPE_TOP_DOWN | ZSCOPE_BOTTOM_UP);
        default: return 9;
    }
}
