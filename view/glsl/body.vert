// body.vert -- places a rectangle around a shape; body.frag draws the shape in the rectangle.
uniform float least; // px: shapes with a reach below this value are drawn as splats

flat out int texel; // first texel of the attribute
flat out vec4 frame; // px: rectangle around the shape; x, y: center; z, w: half width and half height
flat out vec3 shape; // x: radius (px); y: number of vertices; z: 1 for an upright rectangle, 2 for a segment, else 0
flat out vec4 ends;  // px: the first two vertices
flat out vec2 last;  // px: the last vertex
flat out vec3 color;
flat out float reach; // px: reach of the shape
flat out int hollow;
flat out float tint; // opacity of the interior of a hollow shape
flat out float bold; // width of the outline, divided by its usual width
out vec2 local; // px, in the frame of the shape

void main()
{
	texel = 9 * max(name.x, 0);
	vec4 around = texelFetch(table, cell(texel), 0), sizes = texelFetch(table, cell(texel + 1), 0), base = texelFetch(table, cell(texel + 2), 0);
	frame = around * scale;
	ends = texelFetch(table, cell(texel + 3), 0) * scale;
	int end = max(int(sizes.y) - 1, 0);
	vec4 two = texelFetch(table, cell(texel + 3 + end / 2), 0) * scale;
	last = (end & 1) == 0 ? two.xy : two.zw;
	shape = vec3(sizes.x * scale, sizes.y, base.w);
	reach = sizes.z * scale;
	color = base.rgb;
	hollow = 0;
	tint = 0.0;
	bold = 1.0;
	local = vec2(0.0);
	gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
	int mark = mark_of(first + gl_InstanceID);
	if (hidden(mark) || name.x < 0 || (reach < least && sizes.w > 0.0) || unseen(sizes.z))
		return;
	color = shown_color(base.rgb);
	hollow = int(name.y < 0 || mark != 0);
	if (mark != 0)
	{
		float flash = float(mark >> 2) / 63.0;
		color = mix(sensor, vec3(0.95, 0.65, 0.10), flash);
		tint = ((mark & 2) != 0 ? 0.22 : 0.0) + 0.3 * flash;
		if (reach < 16.0) // small sensors, such as coins, are filled
			tint = max(tint, 0.55);
		bold = 1.0 + 2.0 * flash;
	}
	vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
	vec2 at = around.xy + corner * (around.zw + 2.0 / scale);
	local = at * scale;
	gl_Position = vec4(clip_of(pose.xy + turned(at)), 0.0, 1.0);
}
