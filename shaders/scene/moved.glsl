// Which instances moved since the last update: a bit each.
layout(scalar, set = 0, binding = kBindMovedInstances) readonly buffer MovedInstancesBuffer { uint movedInstances[]; };

bool instanceMoved(uint instance) { return ((movedInstances[instance >> 5] >> (instance & 31u)) & 1u) != 0u; }
