// Blanks the slots of every cell and zeroes its reserved texels.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/grid/grid.glsl"

layout(local_size_x = 8, local_size_y = 4, local_size_z = 4) in;

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  GridParameters grid = gridParameters();
  if (any(greaterThanEqual(texel, gridTexelCount(grid)))) return;
  int slot = texel[grid.stretchAxis] % grid.stride;
  imageStore(gridImage, texel, uvec4(slot < grid.capacity ? kBlank : 0u));
}
