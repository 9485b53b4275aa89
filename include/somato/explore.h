#pragma once

// Bodies that explore objects and materials, simulated or your own. Link somato::simulation for the
// simulated ones.

#include "somato/bodies/body.h"
#include "somato/bodies/explore_by.h"
#include "somato/bodies/explorer.h"
#include "somato/bodies/exploring.h"
#include "somato/bodies/material.h"
#include "somato/bodies/object_table.h"
#include "somato/simulation/sense.h"
#include "somato/simulation/simulated_explorer.h"
#include "somato/simulation/simulated_hand.h"
