// box.frag -- draws the edges of an axis-aligned box, one pixel wide.
flat in vec4 edges;
out vec4 pixel;

void main()
{
	vec2 middle = 0.5 * (edges.xy + edges.zw), q = abs(gl_FragCoord.xy - middle) - 0.5 * (edges.zw - edges.xy);
	float d = abs(max(q.x, q.y));
	if (d > 1.0)
		discard;
	pixel = vec4(0.16, 0.42, 0.60, 0.75 * clamp(1.0 - d, 0.0, 1.0));
}
