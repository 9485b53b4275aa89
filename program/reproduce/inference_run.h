#pragma once

#include "flags/command_line.h"
#include "reproduce/sweep_run.h"
#include "somato/core/result.h"
#include "studies/inference/inference_results.h"

namespace somato::program {

/// Infers the unknowns of a sweep with targets from its draws, and runs settings of the posterior
/// with fresh seeds in the folder `fresh` of its output. Errors: those of infer() and SweepRun.
Result<InferenceResults> run_inference(const SweepRequest& request, SweepResults draws);

/// Writes inference.json, and the files of the systems with each accepted setting in folders
/// `bodies/01`, ... Errors: kSystem.
Result<void> save_inference(const SweepRequest& request, const InferenceResults& results);

}  // namespace somato::program
