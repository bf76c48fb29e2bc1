// SPDX-License-Identifier: MIT
// tools.c -- what the user does to the world besides dragging: throws bodies in, pours them, sets off explosions.
#include "view/window/tools.h"
#include "view/window/viewer.h"
#include <math.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#define THROWN_SIZE 28.0f     // px: bodies that the user throws in are visible at any scale
#define BLAST       50.0f     // px: the radius of an explosion at first
#define GROWS       180.0f    // px/s: by which it grows
#define LARGEST     500.0f    // px
#define SAMPLES     256       // bodies that are looked at to find what is poured
#define LARGE       4.0f      // times the common size: what is larger is not poured
#define WIDE        1.6f      // reaches of a common body that it is wide
#define APART       2.05f     // reaches between poured bodies
#define TURN        2.399963f // rad: the golden angle, so that no two bodies are poured at one place soon
#define MOST_POURED 16

static const Color flame = {222, 84, 20}, water = {52, 116, 178};

void tools_launch(Viewer* v)
{
	v->grab.at = camera_point(&v->camera, v->x, v->y);
	if (grab_launch(&v->grab, THROWN_SIZE / v->camera.scale) != SCREE_OK)
		viewer_show(v, scree_error());
	else
		viewer_update_world(v);
}

// Whether bodies like this one are poured; its attribute.
static bool is_common(Viewer* v, scree_body body, scree_attribute* attribute)
{
	scree_world* world = v->session.world;
	scree_body_type type;
	scree_collidable collidable;
	uint32_t sees;
	int shapes = 0;
	if (!scree_body_is_valid(world, body) || scree_body_get_type(world, body, &type) != SCREE_OK ||
	    type != SCREE_BODY_DYNAMIC || scree_body_get_collidables(world, body, &collidable, 1, &shapes) != SCREE_OK ||
	    shapes != 1 || scree_collidable_get_sensor(world, collidable, &sees) != SCREE_OK || sees ||
	    scree_collidable_get_attribute(world, collidable, attribute) != SCREE_OK)
		return false;
	const RenderTables* tables = &v->renderer.tables;
	return (int)attribute->index < tables->attribute_count &&
	       tables->attributes[attribute->index].shape.reach <= LARGE * tables->size;
}

static void add_kind(Tools* tools, scree_attribute attribute)
{
	for (int k = 0; k < tools->kind_count; ++k)
		if (tools->kinds[k].index == attribute.index)
			return;
	if (tools->kind_count < POUR_KINDS)
		tools->kinds[tools->kind_count++] = attribute;
}

static void find_kinds(Viewer* v)
{
	const RenderTables* tables = &v->renderer.tables;
	int every = (tables->body_count + SAMPLES - 1) / SAMPLES;
	v->tools.kind_count = 0;
	for (int k = 0; k < tables->body_count; k += every)
	{
		scree_attribute attribute;
		if (is_common(v, tables->bodies[k], &attribute))
			add_kind(&v->tools, attribute);
	}
}

void tools_pour(Viewer* v, bool down)
{
	if (down && !v->tools.pouring)
	{
		find_kinds(v);
		if (v->tools.kind_count == 0)
			viewer_show(v, "this scene has no bodies of one shape that could be poured; t throws one in");
		v->tools.pour = v->tools.kind_count > 0;
	}
	v->tools.pouring = down && v->tools.kind_count > 0;
}

// The radius of the disc that is poured into, m.
static float pour_radius(const Viewer* v) { return APART * v->renderer.tables.size * sqrtf((float)v->tools.rate); }

// Places on a disc, apart from each other. Returns how many there are.
static int choose_places(Viewer* v, scree_probe* probes)
{
	float reach = v->renderer.tables.size, radius = pour_radius(v);
	int count = 0;
	for (int k = 0; k < 4 * v->tools.rate && count < v->tools.rate; ++k)
	{
		int turn = v->tools.poured + k;
		float angle = TURN * (float)turn, away = radius * sqrtf(fmodf(0.618034f * (float)turn, 1.0f));
		scree_vec at = {v->grab.at.x + away * cosf(angle), v->grab.at.y + away * sinf(angle)};
		bool free = fabsf(at.x) < SCREE_HUGE && fabsf(at.y) < SCREE_HUGE;
		for (int n = 0; n < count && free; ++n)
			free = hypotf(at.x - probes[n].pose.position.x, at.y - probes[n].pose.position.y) > APART * reach;
		if (free)
			probes[count++] = (scree_probe){.pose = {at, {cosf(angle), sinf(angle)}}};
	}
	return count;
}

static scree_status pour(Viewer* v, bool* added)
{
	scree_world* world = v->session.world;
	scree_probe probes[MOST_POURED];
	scree_body_def defs[MOST_POURED];
	scree_shape circle;
	scree_found_list list;
	int count = choose_places(v, probes), made = 0;
	v->tools.poured += count > 0 ? count : 1;
	if (count == 0)
		return SCREE_OK;
	scree_status status = scree_shape_make_circle((scree_vec){0, 0}, v->renderer.tables.size, &circle);
	if (status == SCREE_OK)
		status = scree_world_list_shapes(world, NULL, &circle, probes, count, &list);
	for (int k = 0; k < count && status == SCREE_OK; ++k)
	{
		if (list.first[k + 1] > list.first[k])
			continue;
		defs[made] = scree_body_def_default();
		defs[made].attribute = v->tools.kinds[(v->tools.poured + k) % v->tools.kind_count];
		defs[made++].pose = probes[k].pose;
	}
	*added = *added || made > 0;
	return status == SCREE_OK && made > 0 ? scree_bodies_create(world, defs, made, NULL) : status;
}

bool tools_step(Viewer* v, bool* added)
{
	if (!v->tools.pouring && !v->tools.pour)
		return true;
	v->tools.pour = false;
	scree_status status = pour(v, added);
	if (status == SCREE_OK)
		return true;
	v->tools.pouring = false;
	viewer_show(v, scree_error());
	return status != SCREE_ERROR_DEVICE_FAILED;
}

// m, from the middle: nearer bodies get all of it, and those twice as far away nothing.
static float blast_radius(const Viewer* v)
{
	float grown = BLAST + GROWS * (float)(glfwGetTime() - v->tools.blast_time);
	return fminf(grown, LARGEST) / v->camera.scale;
}

static void explode(Viewer* v)
{
	const RenderTables* tables = &v->renderer.tables;
	scree_blast_def def = scree_blast_def_default();
	int count = 0;
	def.position = v->grab.at;
	def.radius = def.falloff = blast_radius(v);
	// mass by width of a common body: what is as dense and as large gets the speed
	def.impulse = v->tools.blast * fmaxf(tables->density * WIDE * tables->size, 1.0e-6f);
	v->session.hashed = false;
	if (scree_world_blast(v->session.world, &def, &count) != SCREE_OK)
	{
		viewer_show(v, scree_error());
		return;
	}
	char sentence[80];
	snprintf(sentence, sizeof sentence, "the explosion pushes %d shape%s", count, count == 1 ? "" : "s");
	viewer_show(v, sentence);
}

void tools_blast(Viewer* v, bool down)
{
	v->grab.at = camera_point(&v->camera, v->x, v->y);
	if (down && !v->tools.blasting)
		v->tools.blast_time = glfwGetTime();
	if (!down && v->tools.blasting)
		explode(v);
	v->tools.blasting = down;
}

void tools_mark(Viewer* v)
{
	Strokes* strokes = &v->renderer.strokes;
	if (v->tools.blasting)
	{
		float radius = blast_radius(v) * v->camera.scale;
		strokes_ring(strokes, v->grab.at, 2.0f * radius, 2.5f, flame, 230);
		strokes_ring(strokes, v->grab.at, 4.0f * radius, 1.0f, flame, 140);
	}
	if (v->tools.pouring)
		strokes_ring(strokes, v->grab.at, 2.0f * pour_radius(v) * v->camera.scale, 1.5f, water, 200);
}
