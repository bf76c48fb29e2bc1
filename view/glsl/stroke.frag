// stroke.frag -- draws a stroke by the distance from its middle line.
flat in vec2 stroke;
flat in float ring; // px: half the line width of a ring; 0: a filled dot or a line
flat in vec4 color;
flat in float fade;
in vec2 local;
out vec4 pixel;

void main()
{
	float d = length(vec2(max(abs(local.x) - stroke.x, 0.0), local.y)) - stroke.y;
	float share = stroke.x > 0.0 ? clamp(0.5 + 0.5 * local.x / stroke.x, 0.0, 1.0) : 0.0;
	d = ring > 0.0 ? abs(d) - ring : d;
	pixel = vec4(color.rgb, mix(color.a, fade, share) * clamp(0.5 - d, 0.0, 1.0));
}
