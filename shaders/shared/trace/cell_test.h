// Tests of a ray against the references of one cell, and the hit that comes of them. No include guard: C++ includes it inside a class.

// Nearest hit among a cell's references.
struct CellHit {
  float t;
  uint reference;      // kNoReference: none
  uint lastReference;  // the last one encountered: what a voxel hit reports
  int stored;          // references read
  bool cut;            // the loop ended without a reason
};

SHARED Triangle loadReferenced(uint reference) {
  return loadWorldTriangle(loadInstance(referenceInstance(reference)).firstWorldTriangle + referenceTriangle(reference));
}

// Tests every reference of a cell and keeps the nearest of `best` and the hits within `window` (low, high). Of equal distances the
// smaller reference wins. keyed: alpha may turn hits down.
SHARED CellHit testCell(GridParameters grid, Ray ray, ivec3 cell, CellHit best, vec2 window, bool keyed) {
  CellList list = shownList(grid, cell);
  uint reference = kNoReference;
  int place = 0;
  for (; place < list.most; ++place) {
    reference = shownReference(grid, list, place);
    if (reference == kNoReference) break;

    Triangle triangle = loadReferenced(reference);
    TriangleTest test = testTriangle(ray, triangle, window.x, window.y);
    uint alphaByte = 256u;
    if (test.verdict == kTestHit) {
      if (test.t > best.t || (test.t == best.t && reference > best.reference)) {
        test.verdict = kTestFarther;
      } else if (keyed && !keyingPasses(reference, alphaPasses(reference, triangle, rayPoint(ray, test.t), alphaByte))) {
        test.verdict = kTestAlpha;
      } else {
        best.t = test.t;
        best.reference = reference;
      }
    }
    ON_TEST(place, reference, test, alphaByte);
    best.lastReference = reference;
  }
  best.stored = heldCount(cell, place);
  best.cut = place < list.most && reference != kNoReference;
  return best;
}

// The same with alpha keying. What alpha keying loads stays out of the first loop: only where the nearest triangle is keyed, all are tested
// again with it. Where tests are watched, once is enough.
SHARED CellHit queryCell(GridParameters grid, Ray ray, ivec3 cell, CellHit best, vec2 window) {
  bool keyed = TESTS_WATCHED;
  CellHit nearest = best;
  if (!TESTS_WATCHED) {
    nearest = testCell(grid, ray, cell, best, window, false);
    if (nearest.reference != best.reference) {
      uint material = loadInstance(referenceInstance(nearest.reference)).material;
      keyed = (loadMaterial(material).flags & kMaterialAlphaKeyed) != 0u;
    }
  }
  if (keyed) nearest = testCell(grid, ray, cell, best, window, true);
  return nearest;
}

// What a query of the cell starts with: nothing hit yet, or the nearest hit of the cells before.
SHARED CellHit nearestSoFar(float t, uint reference) {
  CellHit hit;
  hit.t = t;
  hit.reference = reference;
  hit.lastReference = kNoReference;
  hit.stored = 0;
  hit.cut = false;
  return hit;
}

// All that a ray asks of a cell: the nearest hit within the window that counts.
SHARED CellHit askCell(GridParameters grid, Ray ray, ivec3 cell, CellHit before, vec2 window) {
  CellHit best = queryCell(grid, ray, cell, before, window);
  if (!hitCounts(cell)) {
    best.t = before.t;
    best.reference = before.reference;
  }
  return best;
}

// Adds the barycentrics. After the loops, not in them: a group of invocations that run together pays for it once.
SHARED Hit finishHit(Ray ray, Hit hit) {
  if (hit.kind != kHitTriangle && hit.kind != kHitVoxel) return hit;
  Triangle triangle = loadReferenced(hit.reference);
  vec3 point = rayPoint(ray, hit.t);
  vec2 weights = hit.kind == kHitVoxel ? clampedBarycentrics(triangle, point) : barycentrics(triangle, point);
  hit.u = weights.x;
  hit.v = weights.y;
  return hit;
}
