#include "somato/bodies/scene.h"

namespace somato {

const std::vector<std::pair<GeomShape, std::string>>& Choices<GeomShape>::all() {
  static const std::vector<std::pair<GeomShape, std::string>> choices = {
      {GeomShape::kBox, "box"},
      {GeomShape::kSphere, "sphere"},
      {GeomShape::kCapsule, "capsule"},
      {GeomShape::kCylinder, "cylinder"},
      {GeomShape::kEllipsoid, "ellipsoid"},
      {GeomShape::kMesh, "mesh"}};
  return choices;
}

const std::vector<std::pair<GeomRole, std::string>>& Choices<GeomRole>::all() {
  static const std::vector<std::pair<GeomRole, std::string>> choices = {
      {GeomRole::kHand, "hand"}, {GeomRole::kObject, "object"}, {GeomRole::kTable, "table"}};
  return choices;
}

}  // namespace somato
