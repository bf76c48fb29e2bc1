// splat.frag -- draws a small square. The opacity of a pixel is the fraction of the pixel that the square covers.
uniform bool coarse;

flat in vec3 color;
flat in vec3 square;
out vec4 pixel;

void main()
{
	if (coarse)
	{
		pixel = vec4(color, min(4.0 * square.z * square.z, 1.0));
		return;
	}
	vec2 low = max(gl_FragCoord.xy - 0.5, square.xy - square.z), high = min(gl_FragCoord.xy + 0.5, square.xy + square.z);
	vec2 covered = max(high - low, 0.0);
	pixel = vec4(color, covered.x * covered.y);
}
