/* Follows a trained system in C: reads frames as lines of numbers from standard input, the channels
   one after the other, and prints the answer after each one. An empty line ends an exploration.

   usage: live MODEL < FRAMES */
#include <somato/c/c_system.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kMostChannels = 64, kMostNumbers = 4096, kLongestLine = 1 << 16 };

static float numbers[kMostNumbers];
static const float* frame[kMostChannels];
static char line[kLongestLine];

/* The number of numbers in the line, or -1 if there is something else. */
static int parse(void) {
  int count = 0;
  char* at = line;
  for (;;) {
    char* end;
    const float number = strtof(at, &end);
    if (end == at) return strspn(at, " \r\n") == strlen(at) ? count : -1;
    if (count == kMostNumbers) return -1;
    numbers[count++] = number;
    at = end;
  }
}

/* Points at the numbers of each channel; returns how many there are together. */
static int arrange(const somato_system* system) {
  int count = 0;
  for (size_t i = 0; i < somato_channels(system); ++i) {
    frame[i] = numbers + count;
    count += (int)somato_channel_elements(system, i);
  }
  return count;
}

static int fail(const char* message) {
  fprintf(stderr, "live: %s\n", message);
  return 1;
}

int main(int count, char** arguments) {
  if (count != 2) return fail("usage: live MODEL < FRAMES");
  char message[500];
  somato_system* system = somato_load(arguments[1], message, sizeof message);
  if (system == NULL) return fail(message);
  if (somato_channels(system) > kMostChannels)
    return fail("there are more channels than this example serves");
  const int needed = arrange(system);
  while (fgets(line, sizeof line, stdin) != NULL) {
    const int given = parse();
    somato_answer answer;
    if (given == 0) {
      somato_start(system, 0.0);
      printf("\n");
      continue;
    }
    if (given != needed)
      return fail("a line has another number of numbers than the channels have elements");
    if (somato_step(system, frame) != SOMATO_OK) return fail(somato_message(system));
    if (somato_read(system, &answer) != SOMATO_OK) return fail(somato_message(system));
    printf("%s %g\n", answer.is_unknown ? "unknown" : somato_class_name(system, answer.nearest),
           answer.distance);
  }
  somato_free(system);
  return 0;
}
