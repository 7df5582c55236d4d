// Springs that turn with the plane of their contact.

#ifndef TRIBOS_TRANSPORT_H
#define TRIBOS_TRANSPORT_H

#include "vec3.h"

namespace tribos {

// Rotation of a contact's plane in a step: the one that takes the normal `before` to the normal `after`, then
// one about `after` by the angle of the bodies' mean spin. Exchanging the two bodies changes the sign of
// normals and springs and no digit.
class Transport {
 public:
  Transport(const Vec3 &before, const Vec3 &after, double angle) :
      axis(cross(before, after)), cosine(dot(before, after)), normal(after)
  {
    // Cayley's form of cosine and sine: a rotation to the last digit, by the angle to third order.
    const double t = 0.5 * angle;
    about_cosine = (1 - t * t) / (1 + t * t);
    about_sine = 2 * t / (1 + t * t);
  }

  // A vector of the old plane in the new one. Its length is kept.
  Vec3 carry(const Vec3 &spring) const
  {
    // Rodrigues' formula.
    const Vec3 tilted =
        spring * cosine + cross(axis, spring) + axis * (dot(axis, spring) / (1 + cosine));
    const Vec3 turned = tilted * about_cosine + cross(normal, tilted) * about_sine;
    // Rounding leaves a component along the normal.
    return turned - normal * dot(normal, turned);
  }

 private:
  Vec3 axis;
  double cosine;
  Vec3 normal;
  double about_cosine, about_sine;
};

}    // namespace tribos

#endif
