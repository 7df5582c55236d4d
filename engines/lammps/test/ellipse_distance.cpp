// Largest distance between the plugin's projection on an ellipse and the kernel's, over the size of the ellipse, for
// random points from inside to far outside, for the poles and for lengths from 0.01 to 100.

#include "ellipse.h"
#include "tribos.h"

#include <cmath>
#include <cstdio>
#include <random>

int main()
{
  const double SPIN_TORQUE = 2.0 / 3, QUARTER_TURN = 1.5707963267948966;
  const int POINTS = 100000, EACH_POLE = 50;
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const tribos_ellipsoid_f64 ellipsoid = {1, 1, SPIN_TORQUE};
  double largest = 0;
  for (int n = 0; n < POINTS; n++) {
    const double length = std::pow(10, 4 * uniform(generator) - 2);
    // Half of the points are inside or near the surface.
    const double away = n % 2 ? 1.2 * uniform(generator) : 1 + std::pow(10, 8 * uniform(generator) - 6);
    const int pole = n % EACH_POLE;
    const double angle = pole == 0 ? 0 : pole == 1 ? QUARTER_TURN : QUARTER_TURN * uniform(generator);
    const tribos_wrench_f64 wrench = {away * std::cos(angle), 0, SPIN_TORQUE * away * std::sin(angle)};
    tribos_projection_f64 projection;
    if (tribos_ellipsoid_project_f64(&ellipsoid, &wrench, length, &projection) != TRIBOS_STATUS_OK) return 1;
    double force = wrench.x, torque = wrench.torque / length;
    tribos::move_into_ellipse(force, torque, SPIN_TORQUE / length);
    const double off = std::hypot(force - projection.wrench.x, torque * length - projection.wrench.torque);
    // NaN would be larger.
    if (!(off <= largest)) largest = off;
  }
  std::printf("%.3e\n", largest);
}
