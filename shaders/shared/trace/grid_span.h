// Where a ray is inside the grid. No include guard: C++ includes it inside a class.

// Narrows [low, high] of a ray's parameter to one axis' pair of grid faces. Quotients in double: only for rays from outside.
SHARED void clipToFaces(float origin, float direction, float faceLow, float faceHigh, INOUT(vec2) range) {
  if (abs(direction) < kTiny) {
    if (origin < faceLow || origin > faceHigh) range = vec2(kFar, -kFar);
    return;
  }
  float first = divide(faceLow - origin, direction);
  float second = divide(faceHigh - origin, direction);
  range.x = max(range.x, min(first, second));
  range.y = min(range.y, max(first, second));
}

// Where a ray is inside the grid: parameters of entry and exit; x > y when it never meets it.
SHARED vec2 gridSpan(GridParameters grid, Ray ray) {
  vec2 range = vec2(0.0f, kFar);
  clipToFaces(ray.origin.x, ray.direction.x, gridFace(grid, 0, 0), gridFace(grid, 0, grid.cellCount.x), range);
  clipToFaces(ray.origin.y, ray.direction.y, gridFace(grid, 1, 0), gridFace(grid, 1, grid.cellCount.y), range);
  clipToFaces(ray.origin.z, ray.direction.z, gridFace(grid, 2, 0), gridFace(grid, 2, grid.cellCount.z), range);
  return range;
}
