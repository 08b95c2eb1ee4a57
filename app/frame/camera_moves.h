// How a person moves a camera: around a point, through space, towards a thing. No ImGui here.
#pragma once

#include "app/frame/showing.h"
#include "app/frame/snapshot.h"

namespace gridscope {

// Moves the target, along the view, to the surface in the middle of the frame: what one orbits around.
void aimCamera(CameraState& camera, const FrameSnapshot& frame);
// Around the target, by angles in radians.
void orbitCamera(CameraState& camera, float turn, float rise);
// The same around any point, which stays where it is in the picture.
void orbitAround(CameraState& camera, const vec3& pivot, float turn, float rise);
// Looks around from where it stands.
void turnCamera(CameraState& camera, float turn, float rise);
// Moves eye and target along right, up and forward, world units.
void moveCamera(CameraState& camera, vec3 rightUpForward);
// Nearer to the target (factor below 1) or farther.
void dollyCamera(CameraState& camera, float factor);
// Looks at a box from the present direction, near enough to fill the view.
void focusCamera(CameraState& camera, const Bounds& bounds);
// Looks at a point from the same side and distance.
void moveTargetTo(CameraState& camera, const vec3& point);
// Would the point be on a picture of this size?
bool inPicture(const CameraPose& pose, const FrameSettings& frame, const vec3& point);
// Looks along an axis at the same target: 0 x, 1 y, 2 z; `positive`: from its positive end.
void lookAlong(CameraState& camera, int axis, bool positive);
// The same, from the other end when one looks from that end already.
void lookAlongOrBack(CameraState& camera, int axis, bool positive);

vec3 worldUp(const CameraState& camera);

}  // namespace gridscope
