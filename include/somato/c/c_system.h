#ifndef SOMATO_C_SYSTEM_H
#define SOMATO_C_SYSTEM_H

/// A trained system for programs in C, and for every language that calls C: a node of ROS 2, Rust,
/// a bridge of a microcontroller. No exception leaves these functions, and the structures keep
/// their layout within a major version. docs/c.md has an example.
///
/// A pointer to a system is used by one thread at a time; different systems are independent.

#include <stddef.h>

// NOLINTBEGIN(modernize-use-using,readability-identifier-naming): the language is C.

#ifdef __cplusplus
extern "C" {
#endif

/// A trained system and the exploration that it is following.
typedef struct somato_system somato_system;

/// Result of a function: 0, or the kind of the error that somato_message() describes.
typedef enum somato_status {
  SOMATO_OK = 0,
  SOMATO_USAGE = 1,    ///< A wrong argument, or a call at the wrong time.
  SOMATO_DATA = 2,     ///< The content of a file, or values that a module refuses.
  SOMATO_FAILED = 3,   ///< The operating system reported an error, such as a full disk.
  SOMATO_INTERNAL = 4  ///< No memory, or a fault of the library.
} somato_status;

/// The answer of a system to the exploration so far.
typedef struct somato_answer {
  size_t winner;           ///< The neuron of the map that is most similar.
  double winner_distance;  ///< Its distance, in the unit of the map's input.
  size_t nearest;          ///< The class of the most similar neuron with a name.
  double distance;         ///< The distance of that neuron.
  double novelty;          ///< From 0, unknown above 1; NaN if the system has no threshold.
  int is_unknown;          ///< 1 if the input is too far from all that the system has learned.
} somato_answer;

/// The version of the library, such as "1.0.0".
const char* somato_version(void);

/// The trained system in a file of `somato run`, ready for its first exploration. It
/// needs names of its neurons, and channels that are recorded together. Returns NULL if it cannot
/// be loaded; `message` then contains the reason, cut to `size` bytes with the final 0. `message`
/// may be NULL if `size` is 0.
somato_system* somato_load(const char* path, char* message, size_t size);

/// Frees a system; NULL is permitted.
void somato_free(somato_system* system);

/// Why the last call with this system failed: what is wrong, where, and what to do. Empty if it did
/// not. Valid until the next call with the system.
const char* somato_message(const somato_system* system);

/// The number of channels of a frame.
size_t somato_channels(const somato_system* system);

/// The name of a channel; NULL if there is no such channel.
const char* somato_channel_name(const somato_system* system, size_t channel);

/// The number of elements of a channel; 0 if there is no such channel.
size_t somato_channel_elements(const somato_system* system, size_t channel);

/// The name of a class, by the number in somato_answer; NULL if there is no such class. Valid until
/// the next call of somato_teach().
const char* somato_class_name(const somato_system* system, size_t number);

/// Begins an exploration. `frame_rate` is its number of frames per second, or 0 if unknown. The
/// first one begins by itself, with an unknown rate.
somato_status somato_start(somato_system* system, double frame_rate);

/// Processes a frame: for each channel its elements, in the order of the channels, all of them
/// valid. After an error, somato_start() is required. It does not allocate memory once that of the
/// system is large enough (docs/c.md).
somato_status somato_step(somato_system* system, const float* const* frame);

/// The answer to the exploration so far, which may continue. `answer` is only written if the call
/// succeeds.
somato_status somato_read(somato_system* system, somato_answer* answer);

/// Teaches the name of the exploration so far, after which the system answers this name for it. A
/// new name becomes a new class. The exploration ends: somato_start() is required.
somato_status somato_teach(somato_system* system, const char* name);

/// Saves the system with all that it has learned; the file is complete or unchanged.
somato_status somato_save(somato_system* system, const char* path);

#ifdef __cplusplus
}
#endif

// NOLINTEND(modernize-use-using,readability-identifier-naming)

#endif
