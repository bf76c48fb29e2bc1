// body.frag -- draws a shape by its signed distance: filled, with a thin darker rim. Circles also have a radius line.
uniform sampler2D table;
uniform float scale; // px per metre
uniform float line;  // px: width of rims

flat in int texel;
// The vertex shader computes these values, because here software renderers would fetch their texels in all branches.
flat in vec4 frame;
flat in vec3 shape;
flat in vec4 ends;
flat in vec2 last;
flat in vec3 color;
flat in float reach;
flat in int hollow;
flat in float tint;
flat in float bold;
in vec2 local;
out vec4 pixel;

vec2 vertex(int k)
{
	vec4 two = texelFetch(table, cell(texel + 3 + k / 2), 0) * scale;
	return (k & 1) == 0 ? two.xy : two.zw;
}

float segment_distance(vec2 p, vec2 a, vec2 b)
{
	vec2 ab = b - a;
	return length(p - a - ab * clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0));
}

// Returns the distance of a point from the hull of the vertices, px. For a point inside of the hull, returns minus the
// distance from the nearest edge.
float hull_distance(vec2 p, int count)
{
	vec2 a = last;
	float outside = 1.0e9, inside = -1.0e9;
	for (int k = 0; k < count; ++k)
	{
		vec2 b = vertex(k), edge = normalize(b - a);
		outside = min(outside, segment_distance(p, a, b));
		inside = max(inside, dot(p - a, vec2(edge.y, -edge.x)));
		a = b;
	}
	return inside < 0.0 ? inside : outside;
}

void main()
{
	float radius = shape.x, d;
	int count = int(shape.y), form = int(shape.z);
	if (form == 1) // an axis-aligned rectangle
	{
		vec2 q = abs(local - frame.xy) - frame.zw + radius;
		d = length(max(q, 0.0)) + min(max(q.x, q.y), 0.0);
	}
	else if (count == 1)
		d = length(local - ends.xy);
	else
		d = count == 2 ? segment_distance(local, ends.xy, ends.zw) : hull_distance(local, count);
	d -= radius;

	if (form == 2 || hollow == 1)
	{
		float wide = max(2.0 * line, 1.5) * bold;
		vec3 edge = hollow == 1 ? color : vec3(157, 154, 147) / 255.0;
		pixel = vec4(edge, max(clamp(0.5 + 0.5 * wide - abs(d), 0.0, 1.0), tint * clamp(0.5 - d, 0.0, 1.0)));
		return;
	}
	float rim = clamp(d + line + 0.5, 0.0, 1.0);
	vec2 q = local - ends.xy;
	if (count == 1 && q.x > 0.0)
		rim = max(rim, clamp(0.5 + 0.5 * line - abs(q.y), 0.0, 1.0));
	rim *= smoothstep(2.5, 6.0, reach);
	pixel = vec4(color * (1.0 - 0.38 * rim), clamp(0.5 - d, 0.0, 1.0));
}
