// Who lost what, and what it cost: per cell what it was asked to take, stored and refused; per triangle, instance and mesh the references
// lost and where; and the rays that do not agree because of it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/truth/truth.h"

namespace gridscope {

struct CellLoss {
  ivec3 cell{0};
  uint32_t tried = 0;  // stored + refused
  uint32_t stored = 0;
  uint32_t refused = 0;
  uint32_t rays = 0;  // rays whose cause took place here
};

struct TriangleLoss {
  uint32_t reference = kNoReference;
  uint32_t stored = 0;    // cells that hold it
  uint32_t lost = 0;      // cells that refused it
  uint32_t rays = 0;      // rays that should have hit it and do not agree, whatever the cause
  uint32_t lostRays = 0;  // of these, by its lost references: refused or gate
};

// A cell that lost references of a group.
struct GroupCell {
  ivec3 cell{0};
  uint32_t lost = 0;  // references
  uint32_t rays = 0;  // that this cost: of the group's lostRays, those whose event took place here
};

// Sums over an instance's, or a mesh's, triangles.
struct GroupLoss {
  uint32_t index = 0;  // of the scene's instance, or of the mesh
  uint64_t triangles = 0;
  uint64_t stored = 0;
  uint64_t lost = 0;
  uint64_t rays = 0;
  uint64_t lostRays = 0;
  std::array<uint64_t, kVerdictCount> verdicts{};  // of the rays
  std::vector<GroupCell> where;                    // the kMostGroupCells cells that cost it the most rays, then lost the most references
};

inline constexpr size_t kMostGroupCells = 10;

struct Ledger {
  std::vector<CellLoss> cells;          // that were asked to take one or more; x fastest
  std::vector<TriangleLoss> triangles;  // all of them, by rising reference
  std::vector<GroupLoss> instances;     // of the scene's instances that have triangles, by rising index
  std::vector<GroupLoss> meshes;        // by rising index
};

// `truths`: of the frame's rays; empty: the costs in rays are 0.
Ledger makeLedger(const TruthInput& input, std::span<const RayTruth> truths);

// Indices of the `count` elements that cost the most rays, most first; those without cost are left out.
std::vector<size_t> worstOf(std::span<const CellLoss> cells, size_t count);
std::vector<size_t> worstOf(std::span<const TriangleLoss> triangles, size_t count);
std::vector<size_t> worstOf(std::span<const GroupLoss> groups, size_t count);

}  // namespace gridscope
