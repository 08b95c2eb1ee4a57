// Update, moved: in each touched cell, takes the references of moved instances out and closes the gaps in order; where dynamic
// references had been refused, takes all dynamic ones out, for what was refused is not known any more.
#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require

#include "shaders/gpu/bindings.glsl"
#include "shaders/grid/grid.glsl"
#include "shaders/scene/moved.glsl"
layout(scalar, set = 0, binding = kBindCellMarks) buffer CellMarksBuffer { uint cellMarks[]; };
layout(scalar, set = 0, binding = kBindUpdateCounts) buffer UpdateCountsBuffer { uint cellsTouched; uint cellsRebuilt; };

layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

void main() {
  ivec3 cell = ivec3(gl_GlobalInvocationID);
  GridParameters grid = gridParameters();
  if (!gridContains(grid, cell)) return;
  uint index = cellNumber(grid, cell);
  if (cellMarks[index] == 0u) return;
  atomicAdd(cellsTouched, 1u);

  ivec3 refusedTexel = gridRefusedTexel(grid, cell, true);
  bool rebuild = imageLoad(gridImage, refusedTexel).x != 0u;
  if (rebuild) {
    cellMarks[index] |= kCellRebuilt;
    atomicAdd(cellsRebuilt, 1u);
    imageStore(gridImage, refusedTexel, uvec4(0u));
  }

  uint firstDynamic = firstDynamicReference(grid);
  int kept = 0;
  for (int slot = 0; slot < grid.capacity; ++slot) {
    ivec3 texel = gridTexel(grid, cell, slot);
    uint reference = slotLoad(texel);
    if (reference == kBlank) break;
    bool goes = reference >= firstDynamic && (rebuild || instanceMoved(referenceInstance(reference)));
    if (goes || kept < slot) imageStore(gridImage, texel, uvec4(kBlank));
    if (!goes) {
      if (kept < slot) imageStore(gridImage, gridTexel(grid, cell, kept), uvec4(reference));
      ++kept;
    }
  }
}
