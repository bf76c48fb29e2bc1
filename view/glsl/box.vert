// box.vert -- computes the axis-aligned box around a placed shape.
uniform vec2 size; // size of the picture, px

flat out vec4 edges; // px: lower and upper corner

void main()
{
	int texel = 9 * max(name.x, 0);
	vec4 sizes = texelFetch(table, cell(texel + 1), 0);
	gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
	edges = vec4(0.0);
	if (hidden(mark_of(first + gl_InstanceID)) || name.x < 0 || sizes.z * scale < 2.0 || unseen(sizes.z))
		return;
	vec2 low = vec2(1.0e9), high = vec2(-1.0e9);
	for (int k = 0; k < int(sizes.y); ++k)
	{
		vec4 two = texelFetch(table, cell(texel + 3 + k / 2), 0);
		vec2 at = turned((k & 1) == 0 ? two.xy : two.zw);
		low = min(low, at);
		high = max(high, at);
	}
	low = clip_of(pose.xy + low - sizes.x);
	high = clip_of(pose.xy + high + sizes.x);
	edges = (vec4(low, high) * 0.5 + 0.5) * size.xyxy;
	vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
	gl_Position = vec4(mix(low - 2.0 / size, high + 2.0 / size, corner), 0.0, 1.0);
}
