// center.vert -- places a dot at the center of mass of a dynamic body; stroke.frag draws the dot.
flat out vec2 stroke; // px; x: half the length, which is 0; y: half the width
flat out float ring;
flat out vec4 color;
flat out float fade;
out vec2 local; // px: position relative to the center of the dot

void main()
{
	gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
	stroke = vec2(0.0, 2.5);
	ring = 0.0;
	color = vec4(ink, 0.9);
	fade = color.a;
	local = vec2(0.0);
	if (name.x < 0 || name.y < 0 || kind() != 2u || texelFetch(table, cell(9 * name.x + 1), 0).z * scale < 6.0)
		return;
	local = (vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0) * 4.0;
	gl_Position = vec4(clip_of(pose.xy + center + local / scale), 0.0, 1.0);
}
