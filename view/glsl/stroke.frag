// stroke.frag -- a stroke by the distance from its middle line.
flat in vec2 stroke;
flat in vec4 color;
in vec2 local;
out vec4 pixel;

void main()
{
	float d = length(vec2(max(abs(local.x) - stroke.x, 0.0), local.y)) - stroke.y;
	pixel = vec4(color.rgb, color.a * clamp(0.5 - d, 0.0, 1.0));
}
