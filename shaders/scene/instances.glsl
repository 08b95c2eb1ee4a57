// Passes over the world triangles of a range of instances.
layout(scalar, push_constant) uniform ArgumentsBlock { PassArguments arguments; };
#include "shaders/scene/moved.glsl"

// The instance of a world triangle: the last whose first triangle is not behind it. At most 16 iterations.
uint findInstance(uint worldTriangle) {
  uint low = arguments.firstInstance;
  uint high = arguments.endInstance;
  while (high - low > 1u) {
    uint middle = (low + high) / 2u;
    if (instances[middle].firstWorldTriangle <= worldTriangle) low = middle;
    else high = middle;
  }
  return low;
}

bool instanceTaken(uint instance) {
  if (arguments.take == kTakeAll) return true;
  return instanceMoved(instance) == (arguments.take == kTakeMoved);
}
