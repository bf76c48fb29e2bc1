// stroke.vert -- places a line of any width with round ends. A line of length 0 is a dot or a ring.
layout(location = 0) in vec4 ends;  // m: the two endpoints
layout(location = 1) in float wide; // px: width; for a ring, diameter
layout(location = 2) in vec4 tint;
layout(location = 3) in vec2 extra; // x: opacity at the end, 0 to 255; y: line width of a ring in quarters of a pixel

uniform vec4 view;   // x, y: middle of the picture (m); z, w: clip units per metre
uniform float scale; // px per metre

flat out vec2 stroke;
flat out float ring;
flat out vec4 color;
flat out float fade; // opacity at the end
out vec2 local;

void main()
{
	vec2 along = (ends.zw - ends.xy) * scale;
	float stretch = length(along);
	vec2 unit = stretch > 0.0 ? along / stretch : vec2(1.0, 0.0);
	vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
	stroke = vec2(0.5 * stretch, 0.5 * wide);
	ring = 0.125 * extra.y;
	color = tint;
	fade = extra.x / 255.0;
	local = corner * (vec2(0.5 * (stretch + wide), 0.5 * wide) + ring + 1.0);
	vec2 at = 0.5 * (ends.xy + ends.zw) + (unit * local.x + vec2(-unit.y, unit.x) * local.y) / scale;
	gl_Position = vec4((at - view.xy) * view.zw, 0.0, 1.0);
}
