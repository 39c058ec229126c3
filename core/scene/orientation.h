// On which side of a line a point lies, decided exactly for any finite float64 coordinates.
//
// Answer     +1 left of the directed line a -> b (counter-clockwise turn), -1 right of it, 0 on it
// Promise    the sign of the real number (a-c) x (b-c), never that of a rounded one: denormals, 1e308 and points
//            almost in line included
// Cost       a handful of operations while the rounded determinant exceeds its error bound; otherwise one sum of
//            six exact products in fixed point, about 0.2 microseconds
// Source     error bound: Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
//            Predicates, 1997, section 4.1 (ccwerrboundA); the exact sum is our own
#pragma once

namespace zscope {

struct Point2 {
    double x = 0, y = 0;

    friend bool operator==(const Point2&, const Point2&) = default;
};

int orientation(const Point2& a, const Point2& b, const Point2& c);

}  // namespace zscope
