// The section of an inference: which settings agree with observed values, and what their claims do.

import { element } from "../../parts/dom";
import { countOf, fixed } from "../../parts/numbers";
import { lazy } from "../page/lazy";
import type { InferenceReport } from "../page/unpacked";
import { jointFigure } from "./joint";
import { inferenceId, inferenceTitle } from "./names";
import { conflictsFigure, supportedFigure, supportTiles, targetsFigure } from "./supported_claims";
import { calibrationFigure, dependencesFigure, unknownsFigure } from "./unknowns";

export function inferenceSection(inference: InferenceReport, index: number): HTMLElement {
  const id = inferenceId(index);
  return element("section", { id, "aria-labelledby": `${id}-title` }, [
    element("h2", { id: `${id}-title` }, [inferenceTitle(inference)]),
    element("p", { class: "lead" }, [jointWords(inference)]),
    element("p", { class: "muted lead" }, [sizeWords(inference)]),
    supportTiles(inference),
    lazy(900, () => [
      element("div", { class: "figures" }, [supportedFigure(inference, id), jointFigure(inference, id), targetsFigure(inference, id)]),
      element("div", { class: "figures" }, [
        unknownsFigure(inference, id),
        dependencesFigure(inference, id),
        calibrationFigure(inference, id),
        conflictsFigure(inference, id),
      ]),
    ]),
  ]);
}

/** The prior's own prediction first. */
function jointWords({ claims, joint, bodies }: InferenceReport): string {
  const { prior, fresh } = joint;
  return (
    `Of ${countOf(claims.length, "claim")}, ${fixed(prior.mean, 1)} hold in a pair of a setting of the prior, ` +
    `and ${fixed(fresh.mean, 1)} in a fresh pair of ${countOf(bodies, "setting")} of the posterior. ` +
    `Of all fresh pairs together, ${fresh.not_failing} do not fail; by their second measures ${fresh.not_failing_as_written}.`
  );
}

function sizeWords({ draws, pairs, accepted, adjusted, targets, fresh_pairs: fresh }: InferenceReport): string {
  const few = draws < kDecidingDraws ? ` No claim can be excluded, which requires ${kDecidingDraws} draws.` : "";
  const regression = adjusted ? "adjusted by a regression" : "not adjusted";
  return (
    `${countOf(draws, "draw")} with ${countOf(pairs, "map")} of each system; the ${accepted} nearest to ${countOf(targets.length, "observed value")} ` +
    `are accepted, ${regression}. Each setting of the posterior has ${countOf(fresh, "fresh map")} of each system.${few}`
  );
}

const kDecidingDraws = 1000; // kDecidingDraws of src/studies/inference/claim_support.h
