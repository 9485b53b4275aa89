#pragma once

// Self-organizing maps and T-MPSOMs: training, winners, quality, clusters, labels, pictures and
// files of samples.

#include "somato/drawing/map_picture.h"
#include "somato/files/csv.h"
#include "somato/files/npy.h"
#include "somato/maps/clusters.h"
#include "somato/maps/contributions.h"
#include "somato/maps/labels.h"
#include "somato/maps/layers.h"
#include "somato/maps/measured_size.h"
#include "somato/maps/som.h"
#include "somato/maps/som_features.h"
#include "somato/maps/som_learner.h"
#include "somato/maps/som_measures.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"
#include "somato/maps/t_mpsom.h"
