#pragma once

// Studies of systems: protocols, baselines, metrics, reproductions, and their results.

#include "somato/studies/information.h"
#include "somato/studies/next_grasp.h"
#include "somato/studies/own_systems.h"
#include "somato/studies/reproduction.h"
#include "somato/studies/results.h"
#include "somato/studies/study.h"
#include "somato/studies/study_parameters.h"
