#include "reproduce/inference_run.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "base/files/toml_file.h"
#include "base/files/whole_file.h"
#include "flags/output_folder.h"

namespace somato::program {
namespace {

SweepRequest fresh_request(const SweepRequest& request, const InferenceParameters& inference,
                           std::vector<SweepPoint> points) {
  SweepRequest fresh = request;
  fresh.points = std::move(points);
  fresh.part = {};
  fresh.out = request.out / "fresh";
  fresh.pairs.pairs = inference.pairs;
  fresh.pairs.recordings = inference.pairs;
  fresh.pairs.seed = inference.seed;
  return fresh;
}

Result<SweepResults> run_fresh(SweepRequest request) {
  SweepRun run(request);
  SOMATO_TRY_VOID(make_folder(request.out));
  SOMATO_TRY_VOID(run.make_folders());
  SOMATO_TRY([[maybe_unused]] const auto lock, FolderLock::wait(request.out));
  SOMATO_TRY_VOID(run.run());
  return run.results();
}

Result<void> save_body(const std::filesystem::path& folder, const std::vector<NamedFile>& files,
                       const std::vector<std::string>& systems) {
  SOMATO_TRY_VOID(make_folder(folder));
  for (std::size_t i = 0; i < files.size(); ++i) {
    SOMATO_TRY_VOID(
        save_whole((folder / (systems[i] + ".toml")).string(), to_toml(files[i].content)));
  }
  return {};
}

// Those of an earlier run, which may have been of other draws or targets.
void remove_earlier_results(const std::filesystem::path& out) {
  std::error_code missing;
  std::filesystem::remove(out / "inference.json", missing);
  std::filesystem::remove_all(out / "bodies", missing);
}

}  // namespace

Result<InferenceResults> run_inference(const SweepRequest& request, SweepResults draws) {
  const Targets& targets = *request.targets;
  remove_earlier_results(request.out);
  SOMATO_TRY(auto inference, infer(draws, targets));
  const InferenceParameters& given = targets.inference;
  auto points = posterior_points(draws.sweep.sweep, inference.posterior, given.bodies, given.seed);
  SOMATO_TRY(auto fresh, run_fresh(fresh_request(request, given, std::move(points))));
  return with_claims(std::move(draws), targets, std::move(inference), std::move(fresh));
}

Result<void> save_inference(const SweepRequest& request, const InferenceResults& results) {
  SOMATO_TRY_VOID(save_whole((request.out / "inference.json").string(), to_json(results)));
  const std::filesystem::path folder = request.out / "bodies";
  SOMATO_TRY_VOID(make_folder(folder));
  for (std::size_t body = 0; body < results.fresh.points.size(); ++body) {
    SOMATO_TRY(const auto files, files_at(request.sweep, results.fresh.points[body].point));
    SOMATO_TRY_VOID(
        save_body(folder / fmt::format("{:02}", body + 1), files, request.sweep.systems));
  }
  return {};
}

}  // namespace somato::program
