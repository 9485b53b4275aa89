#pragma once

#include <string>

#include "somato/bodies/object.h"

namespace somato {

/// An object of the given size (mm) and mass (kg), of a material with friction 0.5.
inline Object thing(Shape shape, double width, double depth, double height, double mass = 0.2) {
  Object object;
  object.name = "thing";
  object.shape = shape;
  object.size = {width, depth, height};
  object.mass = mass;
  return object;
}

inline Object cylinder_thing() {
  return thing(Shape::kCylinder, 62, 62, 121);
}
inline Object block_thing() {
  return thing(Shape::kBlock, 58, 50, 110);
}
inline Object sphere_thing() {
  return thing(Shape::kSphere, 72, 72, 72);
}

}  // namespace somato
