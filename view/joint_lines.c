// SPDX-License-Identifier: MIT
// joint_lines.c -- draws joints as strokes, in the color of their load.
#include "view/joint_lines.h"
#include "view/theme.h"
#include <math.h>
#include <stdlib.h>

#define MOST  200000 // maximum number of drawn joints: reading a joint takes 0.2 us, and a frame must stay short
#define LEAST 1.2f   // px: anchors whose dot would have a radius below this value have no dot

static const Color loaded = {214, 40, 30};

static void find_bodies(JointLines* lines)
{
	lines->first = 0;
	lines->last = -1;
	for (int k = 0; k < lines->links.count; ++k)
		for (int end = 0; end < 2; ++end) // for a joint on a path, one end is the body that carries the path
		{
			int body = lines->links.list[k].bodies[end];
			if (body < 0)
				continue;
			lines->first = lines->last < 0 || body < lines->first ? body : lines->first;
			lines->last = body > lines->last ? body : lines->last;
		}
}

bool joint_lines_build(JointLines* lines, const RenderTables* tables)
{
	const Sprites sprites = {.bodies = tables->bodies, .body_count = tables->body_count};
	int count = 0;
	joint_lines_close(lines);
	if (scree_world_get_joints(tables->world, NULL, 0, &count) != SCREE_OK)
		return false;
	if (count == 0 || count > MOST)
		return true;
	lines->poses = malloc(((size_t)tables->body_count + 1) * sizeof *lines->poses);
	lines->joints = malloc((size_t)count * sizeof *lines->joints);
	lines->states = malloc((size_t)count * sizeof *lines->states);
	bool good = lines->poses && lines->joints && lines->states && links_list(&lines->links, &sprites, tables->world);
	if (good)
		find_bodies(lines);
	else
		joint_lines_close(lines);
	return good;
}

void joint_lines_close(JointLines* lines)
{
	links_free(&lines->links);
	free(lines->poses);
	free(lines->joints);
	free(lines->states);
	*lines = (JointLines){0};
}

static void drop_destroyed(JointLines* lines, const scree_world* world)
{
	Links* links = &lines->links;
	int left = 0;
	for (int k = 0; k < links->count; ++k)
	{
		if (!scree_joint_is_valid(world, links->list[k].joint))
			continue;
		links->list[left] = links->list[k];
		lines->joints[left++] = links->list[k].joint;
	}
	links->count = left;
}

static void drop_broken(JointLines* lines)
{
	Links* links = &lines->links;
	int left = 0;
	for (int k = 0; k < links->count; ++k)
	{
		if (lines->states[k].broken)
			continue;
		links->list[left] = links->list[k];
		lines->states[left++] = lines->states[k];
	}
	links->count = left;
}

static float force_of(const scree_joint_state* state) { return hypotf(state->force.x, state->force.y); }

scree_status joint_lines_update(JointLines* lines, const RenderTables* tables)
{
	drop_destroyed(lines, tables->world);
	if (lines->links.count == 0)
		return SCREE_OK;
	scree_status status = scree_joints_get_states(tables->world, lines->joints, lines->states, lines->links.count);
	if (status == SCREE_OK && lines->last >= 0)
		status = scree_bodies_get_poses(tables->world, tables->bodies + lines->first, lines->poses + lines->first,
		                                lines->last - lines->first + 1);
	if (status == SCREE_OK)
		drop_broken(lines);
	lines->largest = 0.0f;
	for (int k = 0; k < lines->links.count && status == SCREE_OK; ++k)
		lines->largest = fmaxf(lines->largest, force_of(&lines->states[k]));
	return status;
}

Color joint_color(float share, bool dark)
{
	const Color idle = theme_of(dark)->idle;
	const float from[3] = {(float)idle.r, (float)idle.g, (float)idle.b},
	            to[3] = {(float)loaded.r, (float)loaded.g, (float)loaded.b};
	uint8_t channels[3];
	for (int k = 0; k < 3; ++k)
		channels[k] = (uint8_t)(from[k] + share * (to[k] - from[k]));
	return (Color){channels[0], channels[1], channels[2]};
}

static bool in_view(const scree_vec* points, int count, scree_box box)
{
	scree_vec low = points[0], high = low;
	for (int k = 1; k < count; ++k)
	{
		low = (scree_vec){fminf(low.x, points[k].x), fminf(low.y, points[k].y)};
		high = (scree_vec){fmaxf(high.x, points[k].x), fmaxf(high.y, points[k].y)};
	}
	return low.x <= box.upper.x && high.x >= box.lower.x && low.y <= box.upper.y && high.y >= box.lower.y;
}

static float length_of(const scree_vec* points, int count)
{
	float length = 0.0f;
	for (int k = 1; k < count; ++k)
		length += hypotf(points[k].x - points[k - 1].x, points[k].y - points[k - 1].y);
	return length;
}

static void mark(Strokes* strokes, const scree_vec* points, int count, const int anchors[2], float scale, Color color)
{
	float width = fminf(fmaxf(0.02f * scale, 0.5f), 1.6f), pin = fminf(0.04f * scale, 2.5f);
	for (int k = 1; k < count; ++k)
		strokes_add(strokes, points[k - 1], points[k], width, color, 230);
	for (int end = 0; pin >= LEAST && end < 2; ++end)
	{
		// the dot is omitted in the center of a body, because it would only hide the body
		scree_vec at = points[anchors[end]], center = points[end ? count - 1 : 0];
		bool aside = scale * hypotf(at.x - center.x, at.y - center.y) >= pin;
		if (aside || anchors[end] == (end ? count - 1 : 0))
			strokes_add(strokes, at, at, 2.0f * pin, color, 255);
	}
}

// Returns true if a joint is asleep. The dynamic bodies of a joint sleep together.
static bool asleep(const Link* link, const bool* awake)
{
	const int* b = link->bodies;
	return awake && ((b[0] >= 0 && !awake[b[0]]) || (b[1] >= 0 && !awake[b[1]]));
}

static void mark_rail(const Rail* rail, Strokes* strokes, const scree_pose* poses, const Camera* camera, Color color)
{
	float width = fminf(fmaxf(0.02f * camera->scale, 0.5f), 1.6f);
	scree_box box = camera_box(camera);
	for (int k = 1; k < rail->count; ++k)
	{
		const scree_vec ends[] = {rail_point(rail, poses, k - 1), rail_point(rail, poses, k)};
		if (in_view(ends, 2, box))
			strokes_add(strokes, ends[0], ends[1], width, color, 230);
	}
}

void joint_lines_mark(const JointLines* lines, const bool* awake, Strokes* strokes, const Camera* camera,
                      const Style* style)
{
	scree_box box = camera_box(camera);
	const float largest = fmaxf(lines->largest, 1.0e-9f);
	for (int k = 0; k < lines->links.rail_count && lines->links.count > 0; ++k)
		mark_rail(&lines->links.rails[k], strokes, lines->poses, camera, theme_of(style->dark)->idle);
	for (int k = 0; k < lines->links.count; ++k)
	{
		scree_vec points[LINK_POINTS];
		int anchors[2], count = link_points(&lines->links.list[k], lines->poses, points, anchors);
		bool small = 0.04f * camera->scale < LEAST && length_of(points, count) * camera->scale < style->detail;
		if (small || !in_view(points, count, box))
			continue;
		// the square root makes small loads visible beside large ones
		Color color = joint_color(sqrtf(force_of(&lines->states[k]) / largest), style->dark);
		if (asleep(&lines->links.list[k], awake))
			color = shades_dim(color, theme_of(style->dark)->background);
		mark(strokes, points, count, anchors, camera->scale, color);
	}
}
