#include "somato/maps/batch_training.h"
