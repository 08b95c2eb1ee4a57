// A picture inside the window's interface: one rectangle.
#version 460

layout(push_constant) uniform ArgumentsBlock {
  vec4 corners;  // low x, low y, high x, high y in clip space
  vec4 uvs;      // of the low and the high corner
};
layout(location = 0) out vec2 uv;

void main() {
  vec2 corner = vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1);
  uv = mix(uvs.xy, uvs.zw, corner);
  gl_Position = vec4(mix(corners.xy, corners.zw, corner), 0.0, 1.0);
}
