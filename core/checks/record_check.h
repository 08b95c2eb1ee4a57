// Does the recording trace end as the frame did? Pixels drawn at random from a fixed seed.
#pragma once

#include <vector>

#include "core/pipeline/pipeline.h"

namespace gridscope {

struct RecordComparison {
  uint32_t compared = 0;            // pixels with a ray, drawn with repetition
  std::vector<uint32_t> different;  // pixels whose recorded ray does not end with the frame's hit, bit for bit
};

// Of a pipeline whose trace has run. Draws `count` pixels among those that have a ray; none where no pixel has.
RecordComparison compareRecords(Pipeline& pipeline, uint32_t count);

}  // namespace gridscope
