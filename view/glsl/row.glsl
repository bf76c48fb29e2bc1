// row.glsl -- the beginning of every shader of rows: declares a row, and the tables of render_tables.h.
layout(location = 0) in vec4 pose;   // x, y: position (m); z, w: cosine and sine of the angle
layout(location = 1) in vec2 center; // vector from the position to the center of mass, m
layout(location = 2) in ivec2 name;  // x: attribute, -1 without a collidable; y: body, -1 without a body

uniform vec4 view;   // x, y: middle of the picture (m); z, w: clip units per metre
uniform float scale; // px per metre
uniform int paint;   // position of the paint in paints.def, from 0
uniform vec3 palette[64]; // colors for graph colors
uniform vec3 ramp[17];    // colors of the paint, as in ramp.h
uniform vec3 types[2];    // colors of kinematic and dynamic bodies in the paint by type
uniform vec3 still;       // color of bodies that are not dynamic; in the paint by type only of static bodies
uniform vec3 glass;       // color of collidables without a body
uniform vec3 ink;         // color of marks over bodies
uniform int first;        // first row that is drawn
uniform int marked;       // number of rows in the table `marks`

uniform sampler2D table;      // attributes, 9 texels for each (TEXELS of render_tables.c)
uniform usampler2D kinds;     // per body: type plus 4 times the shade
uniform usampler2D graph;     // per body: highest graph color of its contacts; 255 for no contact
uniform sampler2D shares;     // per body, 0 to 1: square root of (force / force_range); or x, y of the starting place
uniform sampler2D velocities; // per body: velocity, m/s
uniform usampler2D marks;     // per row: mark, with the bits of sensor_marks.h
uniform usampler2D asleep;    // per body: 1 if it is asleep
uniform int sensors;          // 1: sensors are shown
uniform int sleeps;           // 1: the world sleeps, and the table `asleep` is filled
uniform vec3 ground;          // color of the background

const vec3 sensor = vec3(38, 138, 94) / 255.0;
const vec3 character = vec3(196, 62, 40) / 255.0;

vec2 turned(vec2 v) { return vec2(pose.z * v.x - pose.w * v.y, pose.w * v.x + pose.z * v.y); }
vec2 clip_of(vec2 world) { return (world - view.xy) * view.zw; }
uint kind() { return texelFetch(kinds, cell(name.y), 0).x & 3u; } // 0 static, 1 kinematic, 2 dynamic, 3 character

// Returns the mark of a row; 0 for a row that is not a sensor.
int mark_of(int row) { return row < marked ? int(texelFetch(marks, cell(row), 0).x) : 0; }
bool hidden(int mark) { return mark != 0 && sensors == 0; }

// Returns true if a shape with this reach (m) is certainly outside of the picture.
bool unseen(float reach) { return any(greaterThan(abs(clip_of(pose.xy)), 1.0 + reach * view.zw)); }

vec3 graph_color(uint color) { return color == 255u ? vec3(0.86, 0.85, 0.82) : palette[min(color, 63u)]; }

vec3 ramp_color(float t)
{
	float at = clamp(t, 0.0, 1.0) * 16.0;
	int k = min(int(at), 15);
	return mix(ramp[k], ramp[k + 1], at - float(k));
}

// Returns the color of a starting place. The hue changes from left to right; colors are dark at the bottom and light at
// the top.
vec3 start_color(vec2 place)
{
	vec3 hue = ramp_color(place.x);
	return mix(hue * 0.55, mix(vec3(1.0), hue, 0.6), place.y);
}

// Returns a color of the attribute: its first color for place 0, its middle color for 1, its last color for 2, and a
// mixture of two colors for places between these. middle: the middle color.
vec3 shade_color(vec3 middle, float place)
{
	vec3 end = texelFetch(table, cell(9 * name.x + (place < 1.0 ? 7 : 8)), 0).rgb;
	return mix(middle, end, abs(place - 1.0));
}

vec3 row_color(vec3 middle)
{
	if (name.y < 0)
		return glass;
	if (kind() == 3u && paint != 5)
		return character;
	if (kind() != 2u)
		return paint == 5 && kind() != 0u ? types[0] : still;
	if (paint == 1)
	{
		float speed = length(texelFetch(velocities, cell(name.y), 0).xy);
		return ramp_color(speed / (speed + 3.0));
	}
	if (paint == 2)
		return graph_color(texelFetch(graph, cell(name.y), 0).x);
	if (paint == 3)
		return ramp_color(texelFetch(shares, cell(name.y), 0).x);
	if (paint == 4)
		return start_color(texelFetch(shares, cell(name.y), 0).xy);
	// makes each body a little lighter or darker, by its index
	uint mixed = uint(name.y) * 0x9e3779b1u;
	mixed = (mixed ^ mixed >> 15) * 0x85ebca6bu;
	vec3 color = paint == 5 ? types[1] : shade_color(middle, float(texelFetch(kinds, cell(name.y), 0).x >> 2) / 31.0);
	return min(color * (0.92 + 0.16 * float(mixed >> 24) / 255.0), 1.0);
}

// Returns the color of a row: dim if its body is asleep.
vec3 shown_color(vec3 middle)
{
	vec3 color = row_color(middle);
	if (sleeps == 0 || name.y < 0 || texelFetch(asleep, cell(name.y), 0).x == 0u)
		return color;
	return mix(ground, color, 0.4);
}
