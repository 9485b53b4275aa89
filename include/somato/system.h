#pragma once

// Systems of modules: build, train, evaluate, save, load, and run frame by frame; the codes that
// modules compute, for programs that use them without a system.

#include "somato/codes/concatenation.h"
#include "somato/codes/memory.h"
#include "somato/codes/normalization.h"
#include "somato/codes/number_codes.h"
#include "somato/codes/one_hot.h"
#include "somato/codes/spectrum.h"
#include "somato/codes/tensor_product.h"
#include "somato/graph/answers.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/further_learning.h"
#include "somato/graph/live_system.h"
#include "somato/graph/som_model.h"
#include "somato/graph/system.h"
#include "somato/graph/system_contributions.h"
#include "somato/graph/system_description.h"
#include "somato/graph/system_model.h"
#include "somato/graph/system_training.h"
