// splat.vert -- places a small shape as a point, drawn as a square with the area of the shape.
uniform bool coarse; // true: the square covers whole pixels
uniform float least; // px: shapes with at least this reach are not drawn as splats
uniform vec2 size;   // size of the picture, px

flat out vec3 color;
flat out vec3 square; // px: the square; x, y: center; z: half of its side

void main()
{
	int texel = 9 * max(name.x, 0);
	vec4 around = texelFetch(table, cell(texel), 0), sizes = texelFetch(table, cell(texel + 1), 0);
	float side = sizes.w * scale;
	gl_PointSize = coarse ? max(side > 1.25 ? ceil(side) : side, 1.0) : ceil(side) + 2.0;
	gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
	color = vec3(0.0);
	square = vec3(0.0);
	if (mark_of(first + gl_VertexID) != 0 || name.x < 0 || sizes.z * scale >= least || side == 0.0)
		return;
	vec2 at = clip_of(pose.xy + turned(around.xy));
	gl_Position = vec4(at, 0.0, 1.0);
	square = vec3((at * 0.5 + 0.5) * size, 0.5 * side);
	color = shown_color(texelFetch(table, cell(texel + 2), 0).rgb);
}
