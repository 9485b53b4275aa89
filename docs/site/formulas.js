// Converts formulas to MathML: node formulas.js KATEX, from the JSON of the standard input to that of the
// standard output. docs/site/site_math.py runs it.
"use strict";

const katex = require(process.argv[2]);

function convert({ latex, isBlock }) {
  try {
    return { html: katex.renderToString(latex, { output: "mathml", throwOnError: true, displayMode: isBlock }) };
  } catch (error) {
    return { error: error.message };
  }
}

const formulas = JSON.parse(require("fs").readFileSync(0, "utf8"));
process.stdout.write(JSON.stringify(formulas.map(convert)));
