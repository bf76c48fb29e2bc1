// velocity.vert -- places a line from the center of mass to the position that it reaches in 0.15 s at its current
// velocity.
flat out vec2 stroke; // px; x: half the length; y: half the width
flat out float ring;
flat out vec4 color;
flat out float fade;
out vec2 local; // px: position along the line and across it, relative to the middle of the line

void main()
{
	gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
	stroke = vec2(0.0);
	ring = 0.0;
	color = vec4(ink, 0.9);
	fade = color.a;
	local = vec2(0.0);
	if (name.x < 0 || name.y < 0)
		return;
	vec2 a = pose.xy + center, along = texelFetch(velocities, cell(name.y), 0).xy * 0.15;
	float stretch = length(along) * scale;
	if (stretch < 1.0)
		return;
	vec2 unit = along / length(along), corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
	stroke = vec2(0.5 * stretch, 0.7);
	local = corner * vec2(0.5 * stretch + 2.0, 2.7);
	vec2 at = a + 0.5 * along + (unit * local.x + vec2(-unit.y, unit.x) * local.y) / scale;
	gl_Position = vec4(clip_of(at), 0.0, 1.0);
}
