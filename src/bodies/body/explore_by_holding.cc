#include "somato/bodies/explore_by.h"

#include <utility>

#include "bodies/body/frame_log.h"

namespace somato {

Result<Exploration> explore_by_holding(Body& body, double duration, double step) {
  FrameLog frames(body.description(), body.limits().memory);
  while (body.state().time < duration) {
    SOMATO_TRY_VOID(body.step(step, Readings::kRecorded));
    SOMATO_TRY_VOID(frames.append(body.state()));
  }
  return Exploration{{}, {}, std::move(frames).channels()};
}

}  // namespace somato
