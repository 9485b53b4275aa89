#pragma once

#include <array>
#include <string>

#include "somato/bodies/object.h"
#include "somato/core/result.h"

namespace somato::detail {

/// An object as parts of a model in MJCF: a body named "object", whose origin is the middle of its
/// footprint on the table, with one geom named "object".
struct ObjectMjcf {
  std::string assets;  ///< For <asset>.
  std::string bodies;  ///< For <worldbody>, with the stand of a free round object.
};

/// The parts of an object in a scene.
struct ObjectSettings {
  bool free = false;      ///< Free to move under gravity and contacts, or held.
  double friction = 0.5;  ///< Coulomb coefficient of any contact with it.
};

/// An object whose size is known, and where a mesh's file has the middle of its footprint (m).
struct MeasuredObject {
  Object object;
  std::array<double, 3> mesh_origin{};
};

/// Takes the size of a mesh from its file; other shapes know theirs. Errors (kData): a file that
/// the physics engine refuses; (kUsage) a mesh of no size or larger than 1 m.
Result<MeasuredObject> measure_object(Object object);

ObjectMjcf object_mjcf(const MeasuredObject& measured, const ObjectSettings& settings);

}  // namespace somato::detail
