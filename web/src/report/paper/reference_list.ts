// The papers that can be cited, with the facts that the documentation gives.

export interface Reference {
  key: string;
  short: string; // in a text without BibTeX
  kind: "article" | "book" | "misc" | "software";
  fields: [name: string, value: string][];
}

const kJohnssonBalkenius = "Johnsson, Magnus and Balkenius, Christian";

/** By how the claims of a system name them, or by the type of a module. */
export const kReferences: Record<string, Reference> = {
  P06: {
    key: "johnsson2006",
    short: "Johnsson and Balkenius, 2006",
    kind: "misc",
    fields: [
      ["author", kJohnssonBalkenius],
      ["title", "Haptic Perception with a Robotic Hand"],
      ["year", "2006"],
    ],
  },
  P07: {
    key: "johnsson2007",
    short: "Johnsson and Balkenius, 2007",
    kind: "article",
    fields: [
      ["author", kJohnssonBalkenius],
      ["title", "Neural network models of haptic shape perception"],
      ["journal", "Robotics and Autonomous Systems"],
      ["volume", "55"],
      ["pages", "720--727"],
      ["year", "2007"],
    ],
  },
  "Johnsson and Balkenius 2010": {
    key: "johnsson2010",
    short: "Johnsson and Balkenius, 2010",
    kind: "misc",
    fields: [
      ["author", kJohnssonBalkenius],
      ["title", "Haptic perception with an anthropomorphic robot hand"],
      ["year", "2010"],
    ],
  },
  P11: {
    key: "johnsson2011",
    short: "Johnsson and Balkenius, 2011",
    kind: "article",
    fields: [
      ["author", kJohnssonBalkenius],
      ["title", "Sense of Touch in Robots With Self-Organizing Maps"],
      ["journal", "IEEE Transactions on Robotics"],
      ["volume", "27"],
      ["number", "3"],
      ["year", "2011"],
    ],
  },
  som: {
    key: "kohonen2001",
    short: "Kohonen, 2001",
    kind: "book",
    fields: [
      ["author", "Kohonen, Teuvo"],
      ["title", "Self-Organizing Maps"],
      ["publisher", "Springer"],
      ["edition", "3"],
      ["year", "2001"],
    ],
  },
  growing_when_required: {
    key: "marsland2002",
    short: "Marsland et al., 2002",
    kind: "article",
    fields: [
      ["author", "Marsland, Stephen and Shapiro, Jonathan and Nehmzow, Ulrich"],
      ["title", "A self-organising network that grows when required"],
      ["journal", "Neural Networks"],
      ["volume", "15"],
      ["year", "2002"],
    ],
  },
  growing_cells: {
    key: "fritzke1994",
    short: "Fritzke, 1994",
    kind: "article",
    fields: [
      ["author", "Fritzke, Bernd"],
      ["title", "Growing cell structures -- a self-organizing network for unsupervised and supervised learning"],
      ["journal", "Neural Networks"],
      ["volume", "7"],
      ["year", "1994"],
    ],
  },
  growing_grid: {
    key: "fritzke1995",
    short: "Fritzke, 1995",
    kind: "article",
    fields: [
      ["author", "Fritzke, Bernd"],
      ["title", "Growing grid -- a self-organizing network with constant neighborhood range and adaptation strength"],
      ["journal", "Neural Processing Letters"],
      ["volume", "2"],
      ["year", "1995"],
    ],
  },
};

/** A T-MPSOM is cited by the papers that introduced and compared it. */
export const kOfTypes: Record<string, string[]> = { t_mpsom: ["P06", "P07"] };
