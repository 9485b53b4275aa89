#include "view/demonstrated_recording.h"

#include <chrono>
#include <cstdint>
#include <future>
#include <memory>
#include <utility>

#include "terminal/terminal.h"
#include "terminal/wording.h"
#include "views/teaching/preparation.h"

namespace somato::program {
namespace {

using Model = std::shared_ptr<const SystemModel>;

// The system after the last round of preparation.
Result<Model> prepared_model(const ViewSystem& system, const PriorExplorations& explorations,
                             std::uint64_t seed) {
  constexpr auto kLook = std::chrono::milliseconds(50);  // between checks whether to stop
  std::promise<Result<Model>> promise;
  auto model = promise.get_future();
  live::Preparation preparation;
  preparation.start(system, explorations, seed, [&](const Result<live::Prepared>& prepared) {
    if (!prepared) return promise.set_value(fail(prepared.error()));
    if (prepared->is_last) promise.set_value(prepared->model);
  });
  while (model.wait_for(kLook) != std::future_status::ready) {
    if (stop_requested()) preparation.request_stop();
  }
  return model.get();
}

Result<void> train_beforehand(ViewSource& source) {
  if (!source.system || source.prior_explorations.rounds == 0) return {};
  ViewSystem& system = source.systems[*source.system];
  SOMATO_TRY(system.trained, prepared_model(system, source.prior_explorations, source.seed));
  source.prior_explorations.rounds = 0;
  return {};
}

}  // namespace

Result<ViewSource> demonstrated_recording(ViewSource source, std::size_t exploration) {
  if (exploration >= source.plan.size()) {
    return fail(ErrorKind::kUsage,
                "the demonstration has " + counted(source.plan.size(), "exploration"),
                "--exploration");
  }
  const PlannedExploration planned = source.plan[exploration];
  ExploreOptions options;
  options.limits.should_continue = [] { return !stop_requested(); };
  SOMATO_TRY(auto explored, source.explorer->explore(planned.thing, planned.trial, options));
  SOMATO_TRY_VOID(train_beforehand(source));
  source.recording.explorations = {std::move(explored)};
  source.explorer.reset();
  source.plan.clear();
  source.demonstrates = false;
  return source;
}

}  // namespace somato::program
