#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <cstddef>
#include <memory>
#include <string>

#include "somato/core/result.h"

namespace somato::detail {

struct ModelDeleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DataDeleter {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

/// The model of a simulation: constant, so that threads can share it.
using PhysicsModel = std::shared_ptr<const mjModel>;

/// The state of a simulation: one per body.
using PhysicsData = std::unique_ptr<mjData, DataDeleter>;

/// Compiles the model in the MJCF text; `name` is its name in messages. Errors (kData): the message
/// of the physics engine.
Result<std::shared_ptr<mjModel>> compile_model(const std::string& mjcf, const std::string& name);

/// Scratch data for the model, at its initial state. Errors: kSystem when memory is short.
Result<PhysicsData> make_data(const PhysicsModel& model);

/// The two geoms that touch.
inline std::array<int, 2> contact_geoms(const mjContact& contact) {
#if mjVERSION_HEADER >= 315
  return {contact.geom[0], contact.geom[1]};
#else
  return {contact.geom1, contact.geom2};
#endif
}

/// The index of a named thing (mjOBJ_...) of the model, -1 when there is none.
inline int find_in(const mjModel& model, int type, const std::string& name) {
  return mj_name2id(&model, type, name.c_str());
}

/// The row of an array of the engine whose rows have `width` numbers.
template <typename Number>
Number* row_of(Number* first, int row, int width) {
  return first + static_cast<std::ptrdiff_t>(row) * width;
}

/// Fails (kData) once the simulation has diverged: from then on its state means nothing.
Result<void> check_stable(const mjData& data);

}  // namespace somato::detail
