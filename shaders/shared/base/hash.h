// A hash of a number, the same in both languages.
#ifndef GRIDSCOPE_SHARED_HASH_H
#define GRIDSCOPE_SHARED_HASH_H

#include "shaders/shared/base/language.h"

BEGIN_SHARED

// A 32-bit hash (the output function of PCG: O'Neill, 2014).
SHARED uint hashOf(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

END_SHARED

#endif
