// Update, all: blanks every dynamic reference and zeroes the dynamic refusals. A cell's first blank ends it.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/grid/grid.glsl"

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID);
  GridParameters grid = gridParameters();
  if (!gridContains(grid, cell)) return;
  uint firstDynamic = firstDynamicReference(grid);
  for (int slot = 0; slot < grid.capacity; ++slot) {
    ivec3 texel = gridTexel(grid, cell, slot);
    uint reference = slotLoad(texel);
    if (reference == kBlank) break;
    if (reference >= firstDynamic) imageAtomicExchange(gridImage, texel, kBlank);
  }
  if (grid.reserved == 2) imageStore(gridImage, gridRefusedTexel(grid, cell, true), uvec4(0u));
}
