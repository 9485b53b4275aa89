#pragma once

// Recordings of touch: explorations with labels and channels, their MCAP files and CSV import.

#include "somato/recording/csv_import.h"
#include "somato/recording/inspect_recording.h"
#include "somato/recording/layout.h"
#include "somato/recording/recording.h"
#include "somato/recording/recording_file.h"
#include "somato/recording/recording_writer.h"
#include "somato/recording/recover_recording.h"
