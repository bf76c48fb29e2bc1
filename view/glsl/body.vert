// body.vert -- a rectangle around a shape; body.frag draws the shape in it.
uniform float least; // px: shapes of less reach are splats

flat out int texel; // first one of the attribute
flat out vec3 color;
flat out float reach; // px
flat out int hollow;
out vec2 local; // px, in the frame of the shape

void main()
{
	texel = 7 * max(name.x, 0);
	vec4 around = texelFetch(table, texel), sizes = texelFetch(table, texel + 1), base = texelFetch(table, texel + 2);
	reach = sizes.z * scale;
	color = base.rgb;
	hollow = 0;
	local = vec2(0.0);
	gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
	if (name.x < 0 || (reach < least && sizes.w > 0.0) || unseen(sizes.z))
		return;
	color = row_color(base.rgb);
	hollow = int(name.y < 0);
	vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
	vec2 at = around.xy + corner * (around.zw + 2.0 / scale);
	local = at * scale;
	gl_Position = vec4(clip_of(pose.xy + turned(at)), 0.0, 1.0);
}
