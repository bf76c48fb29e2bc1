// SPDX-License-Identifier: MIT
// flashes.c -- draws short marks for events of the world: touches, hits, visits, broken joints.
//
// Flashes fade with simulated time. While the world is paused they stay, so that a single step shows its events.
#include "view/flashes.h"
#include <math.h>
#include <stdlib.h>

#define MOST        1000 // maximum number of flashes per step and layer, so that a frame has at most some thousands
#define MOST_AT_ALL 20000
#define BREAK_LASTS 1.5  // s: duration of the mark of a broken joint; long, because joints rarely break
#define CROSS       7.0f // px: half the diagonal of the cross of a broken joint

static const Color touch_color = {30, 120, 170}, hit_color = {222, 84, 20}, break_color = {160, 20, 30};

void flashes_close(Flashes* flashes)
{
	free(flashes->list);
	*flashes = (Flashes){0};
}

bool flashes_shown(const Style* style)
{
	const bool* layers = style->layers;
	return layers[LAYER_visits] || layers[LAYER_touches] || layers[LAYER_hits] || layers[LAYER_breaks];
}

static bool in_view(scree_box box, scree_vec p)
{
	return p.x >= box.lower.x && p.x <= box.upper.x && p.y >= box.lower.y && p.y <= box.upper.y;
}

// Returns the diameter of a ring: 5 px if the surfaces met slowly, 17 px at 5 m/s, at most 29 px.
static float diameter_of(float speed) { return 5.0f + 24.0f * speed / (speed + 5.0f); }

static void add(Flashes* flashes, Layer layer, scree_vec at, float diameter, double now)
{
	if (flashes->count == flashes->capacity)
	{
		int capacity = flashes->capacity ? 2 * flashes->capacity : 256;
		Flash* list = flashes->count < MOST_AT_ALL ? realloc(flashes->list, (size_t)capacity * sizeof *list) : NULL;
		if (!list)
		{
			++flashes->left_out;
			return;
		}
		flashes->list = list;
		flashes->capacity = capacity;
	}
	flashes->list[flashes->count++] = (Flash){layer, at, diameter, now};
}

typedef struct // events of one kind, each with a point and a speed
{
	const scree_events* events;
	Layer layer;
	int count;
} Kind;

static scree_vec point_of(const Kind* kind, int k, float* speed)
{
	if (kind->layer == LAYER_hits)
	{
		*speed = kind->events->hits[k].approach_speed;
		return kind->events->hits[k].point;
	}
	const scree_contact* c = &kind->events->touches_began[k];
	*speed = fmaxf(c->details[0].approach_speed, c->count > 1 ? c->details[1].approach_speed : 0.0f);
	return c->points[0].point;
}

static void add_kind(Flashes* flashes, const Kind* kind, scree_box box, double now)
{
	float speed;
	int seen = 0, turn = 0;
	for (int k = 0; k < kind->count; ++k)
		seen += in_view(box, point_of(kind, k, &speed));
	flashes->seen += seen;
	int every = (seen + MOST - 1) / MOST;
	for (int k = 0; k < kind->count; ++k)
	{
		scree_vec at = point_of(kind, k, &speed);
		if (!in_view(box, at))
			continue;
		if (turn++ % every == 0)
			add(flashes, kind->layer, at, diameter_of(speed), now);
		else
			++flashes->left_out;
	}
}

// Computes the point at which a joint is attached to its body B, m, in the world. Returns false if the joint or the
// body does not exist.
static bool anchor_of(scree_world* world, scree_joint joint, scree_vec* at)
{
	scree_joint_def def;
	scree_pose pose = {{0, 0}, {1, 0}};
	if (scree_joint_get_def(world, joint, &def) != SCREE_OK)
		return false;
	if (!scree_body_is_null(def.body_b) && scree_body_get_pose(world, def.body_b, &pose) != SCREE_OK)
		return false;
	scree_vec arm = def.frame_b.position;
	*at = (scree_vec){pose.position.x + pose.rotation.c * arm.x - pose.rotation.s * arm.y,
	                  pose.position.y + pose.rotation.s * arm.x + pose.rotation.c * arm.y};
	return true;
}

static void add_breaks(Flashes* flashes, scree_world* world, const scree_events* events, scree_box box, double now)
{
	int added = 0;
	for (int k = 0; k < events->joint_count; ++k)
	{
		scree_vec at;
		if (!events->joints[k].broken)
			continue;
		bool room = added < MOST; // limits the calls of anchor_of, each of which reads a pose
		if (room && (!anchor_of(world, events->joints[k].joint, &at) || !in_view(box, at)))
			continue;
		++flashes->seen;
		++added;
		if (room)
			add(flashes, LAYER_breaks, at, 0.0f, now);
		else
			++flashes->left_out;
	}
}

scree_status flashes_step(Flashes* flashes, RenderTables* tables, const Camera* camera, const Style* style, double now)
{
	scree_events events;
	flashes->seen = flashes->left_out = 0;
	if (!flashes_shown(style))
		return SCREE_OK;
	scree_status status = scree_world_get_events(tables->world, &events);
	if (status != SCREE_OK)
		return status;
	scree_box box = camera_box(camera);
	if (style->layers[LAYER_touches])
		add_kind(flashes, &(Kind){&events, LAYER_touches, events.touches_began_count}, box, now);
	if (style->layers[LAYER_hits])
		add_kind(flashes, &(Kind){&events, LAYER_hits, events.hit_count}, box, now);
	if (style->layers[LAYER_breaks])
		add_breaks(flashes, tables->world, &events, box, now);
	for (int k = 0; style->layers[LAYER_visits] && k < events.visits_began_count; ++k)
	{
		SensorMark* sensor = sensor_marks_find(&tables->sensors, events.visits_began[k].sensor.index);
		if (sensor)
			sensor->lit = now;
	}
	return SCREE_OK;
}

static void mark(const Flash* flash, Strokes* strokes, const Camera* camera, float age)
{
	int opacity = (int)(255.0f * (1.0f - age));
	if (flash->layer != LAYER_breaks)
	{
		// a ring grows by a third while it fades
		float diameter = flash->diameter * (0.75f + 0.25f * age);
		strokes_ring(strokes, flash->at, diameter, 2.0f, flash->layer == LAYER_hits ? hit_color : touch_color, opacity);
		return;
	}
	float arm = CROSS / camera->scale;
	for (int k = -1; k < 2; k += 2)
	{
		scree_vec a = {flash->at.x - arm, flash->at.y - (float)k * arm},
		          b = {flash->at.x + arm, flash->at.y + (float)k * arm};
		strokes_add(strokes, a, b, 3.0f, break_color, opacity);
	}
}

void flashes_mark(Flashes* flashes, Strokes* strokes, const Camera* camera, double now)
{
	int left = 0;
	for (int k = 0; k < flashes->count; ++k)
	{
		const Flash flash = flashes->list[k];
		double age = (now - flash.born) / (flash.layer == LAYER_breaks ? BREAK_LASTS : FLASH_LASTS);
		if (!(age >= 0.0 && age < 1.0))
			continue;
		flashes->list[left++] = flash;
		mark(&flash, strokes, camera, (float)age);
	}
	flashes->count = left;
}
