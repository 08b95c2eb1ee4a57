// The products of a frame, for passes that only read them.
layout(scalar, set = 0, binding = kBindGather) readonly buffer GatherBuffer { GatherPixel gatherPixels[]; };
layout(scalar, set = 0, binding = kBindRays) readonly buffer RaysBuffer { Ray rays[]; };
layout(scalar, set = 0, binding = kBindHits) readonly buffer HitsBuffer { Hit hits[]; };
layout(scalar, set = 0, binding = kBindCounters) readonly buffer CountersBuffer { RayCounters counters[]; };
