// How far a thing moves when a handle of it is dragged on the picture. No ImGui here.
#pragma once

#include "app/frame/projection.h"

namespace gridscope {

enum class DragWay { x, y, z, plane };  // along an axis of the world, or across the view

// The way in the world that takes `centre` along with the mouse from one place of the frame to another. Zero where an axis points at the eye.
vec3 dragOffset(const CameraParameters& camera, const vec3& centre, DragWay way, vec2 from, vec2 to);

// World units at a point that are one pixel of the frame.
float worldPerPixel(const CameraParameters& camera, const vec3& point);

}  // namespace gridscope
