// row.glsl -- the beginning of every shader of rows: a row of the world, and the tables of render_tables.h.
layout(location = 0) in vec4 pose;   // x, y (m), cosine, sine
layout(location = 1) in vec2 center; // from there to the center of mass, m
layout(location = 2) in ivec2 name;  // attribute, -1 where there is no collidable; body, -1 for none

uniform vec4 view;   // middle of the picture (m), clip units a metre
uniform float scale; // px a metre
uniform int paint;   // PAINT_* of renderer.h
uniform vec3 palette[64]; // of graph colors
uniform int first;        // row that is drawn first
uniform int marked;       // rows that have a mark

uniform samplerBuffer table;      // attributes, TEXELS of render_tables.c each
uniform usamplerBuffer kinds;     // of bodies: whether they move, and their shade
uniform usamplerBuffer graph;     // lowest color of a body's contacts, 255 for none
uniform samplerBuffer velocities; // of bodies, m/s
uniform usamplerBuffer marks;     // of rows: bits of sensor_marks.h
uniform int sensors;              // whether they are shown

const vec3 stone = vec3(196, 192, 184) / 255.0;
const vec3 glass = vec3(67, 93, 134) / 255.0;
const vec3 sensor = vec3(38, 138, 94) / 255.0;

vec2 turned(vec2 v) { return vec2(pose.z * v.x - pose.w * v.y, pose.w * v.x + pose.z * v.y); }
vec2 clip_of(vec2 world) { return (world - view.xy) * view.zw; }
bool moves() { return name.y >= 0 && (texelFetch(kinds, name.y).x & 3u) == 2u; }

// The mark of a row, 0 where it is no sensor.
int mark_of(int row) { return row < marked ? int(texelFetch(marks, row).x) : 0; }
bool hidden(int mark) { return mark != 0 && sensors == 0; }

// Whether a shape of this reach (m) lies outside the picture.
bool unseen(float reach) { return any(greaterThan(abs(clip_of(pose.xy)), 1.0 + reach * view.zw)); }

vec3 graph_color(uint color) { return color == 255u ? vec3(0.86, 0.85, 0.82) : palette[min(color, 63u)]; }

// 0 m/s is blue, 3 m/s yellow, faster red.
vec3 speed_color(float speed)
{
	float t = speed / (speed + 3.0) * 2.0;
	vec3 slow = vec3(0.33, 0.45, 0.66), middle = vec3(0.89, 0.72, 0.38), fast = vec3(0.80, 0.28, 0.22);
	return t < 1.0 ? mix(slow, middle, t) : mix(middle, fast, t - 1.0);
}

// A shade of the attribute: 0 is its first color, 1 its middle, 2 its last.
vec3 shade_color(vec3 middle, float place)
{
	vec3 end = texelFetch(table, 9 * name.x + (place < 1.0 ? 7 : 8)).rgb;
	return mix(middle, end, abs(place - 1.0));
}

vec3 row_color(vec3 middle)
{
	if (name.y < 0)
		return glass;
	if (!moves())
		return stone;
	if (paint == 1)
		return speed_color(length(texelFetch(velocities, name.y).xy));
	if (paint == 2)
		return graph_color(texelFetch(graph, name.y).x);
	// a little lighter or darker from body to body
	uint mixed = uint(name.y) * 0x9e3779b1u;
	mixed = (mixed ^ mixed >> 15) * 0x85ebca6bu;
	vec3 color = shade_color(middle, float(texelFetch(kinds, name.y).x >> 2) / 31.0);
	return min(color * (0.92 + 0.16 * float(mixed >> 24) / 255.0), 1.0);
}
