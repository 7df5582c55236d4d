// The nearest point of an ellipse.

#ifndef TRIBOS_ELLIPSE_H
#define TRIBOS_ELLIPSE_H

#include <cmath>

namespace tribos {

// Moves the point (x, y), x and y not below 0, to the nearest one that the ellipse with half axes 1 and b holds.
// Returns whether it has moved.
//
// Outside, the nearest point is (x/(1 + m), b^2 y/(b^2 + m)) with the multiplier m > 0 for which it lies on the ellipse:
// the secular equation of a trust region. Its inverse square root is concave in m, so that Newton's method grows
// monotonically to the root from any bound below it (More and Sorensen, SIAM J. Sci. Stat. Comput. 4 (1983) 553).
inline bool move_into_ellipse(double &x, double &y, double b)
{
  const double b_sq = b * b, along = b * y;
  if (x * x * b_sq + y * y <= b_sq) return false;
  // Neither coordinate of the nearest point exceeds its half axis.
  double m = 0;
  if (x - 1 > m) m = x - 1;
  if (along - b_sq > m) m = along - b_sq;
  // Three to five steps are usual.
  const int MOST_STEPS = 30;
  for (int step = 0; step < MOST_STEPS; step++) {
    const double inv_x = 1 / (1 + m), inv_y = 1 / (b_sq + m);
    const double cosine = x * inv_x, sine = along * inv_y;
    const double size_sq = cosine * cosine + sine * sine;
    const double slope = cosine * cosine * inv_x + sine * sine * inv_y;
    const double next = m + size_sq / slope * (std::sqrt(size_sq) - 1);
    // Rounding ends the growth at the root.
    if (!(next > m)) break;
    m = next;
  }
  x = x / (1 + m);
  y = b_sq * y / (b_sq + m);
  return true;
}

}    // namespace tribos

#endif
