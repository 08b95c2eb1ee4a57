// Runs one view's function over all its elements. CMakeLists.txt writes a copy for each view, with its file's name filled in.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/grid/grid.glsl"
#include "shaders/pipeline/products.glsl"
#include "shaders/shared/grid/slice.h"
#include "shaders/shared/views/element_colour.h"
#include "shaders/views/findings.glsl"

layout(scalar, set = 0, binding = kBindViewElements) writeonly buffer ViewElementsBuffer { ViewElement viewElements[]; };

#include "shaders/views/shading.glsl"
#include "views/@VIEW@.h"

layout(local_size_x = 8, local_size_y = 8) in;

void main() {
  uvec2 place = gl_GlobalInvocationID.xy;
  if (place.x >= parameters.view.width || place.y >= parameters.view.height) return;
  uint index = place.y * parameters.view.width + place.x;
  viewElements[index] = viewElement(index);
}
